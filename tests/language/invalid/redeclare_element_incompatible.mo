// error: redeclare.incompatible line 14 names A, B
model A
  Real x = 1;
end A;
model B
  Real x = 1;
  Real y = 2;
end B;
model Base
  replaceable B b;
end Base;
model Test
  extends Base;
  redeclare A b;
end Test;
