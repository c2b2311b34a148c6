// error: structural.not-constant line 10 names n
package P
  connector C
    Real v; flow Real i;
  end C;
  model Test
    C a[2], b;
    Integer n = integer(time);
  equation
    connect(a[n], b);
  end Test;
end P;
