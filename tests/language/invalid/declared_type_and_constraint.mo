// error: redeclare.incompatible line 10 names A, B
model A
  Real x = 1;
end A;
model B
  Real x = 1;
  Real y = 2;
end B;
model Test
  replaceable A a constrainedby B;
end Test;
