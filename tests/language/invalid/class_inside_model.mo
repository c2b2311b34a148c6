// error: lookup.not-package line 9 names A.B
model A
  Real x = 1;
  model B
    Real y = 2;
  end B;
end A;
model Test
  A.B b;
end Test;
