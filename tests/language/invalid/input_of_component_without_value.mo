// error: balance.local line 2 names b, B says 2 unknowns
block B
  input Real u = 1;
  output Real y;
equation
  y = u;
  u = 1;
end B;
model A
  Real z;
end A;
model Test
  B b;
  A a;
end Test;
