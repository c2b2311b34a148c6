// Names are looked up in the class, then in the classes around it; an inner declaration hides an outer one.
package P
  constant Real k = 1;
  package Inner
    constant Real k = 2;
    constant Real only = 3;
    model A
      Real x = k;
      Real y = P.k;
      Real z = .P.Inner.only;
    end A;
  end Inner;
  model Test
    Inner.A a;
    Real own = k;
  end Test;
end P;
