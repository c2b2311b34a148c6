// error: redeclare.incompatible line 12 names B, A
model A
  Real x = 1;
end A;
model B
  Real y = 1;
end B;
model C
  replaceable A a;
end C;
model Test
  C c(redeclare B a);
end Test;
