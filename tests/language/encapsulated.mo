// An encapsulated class sees predefined types and what it imports, not what is around it (5.3.1).
package P
  constant Real k = 1;
  encapsulated model A
    import P.k;
    Real x = k;
    Integer n = integer(x);
  end A;
  model Test
    A a;
  end Test;
end P;
