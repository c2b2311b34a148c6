// error: redeclare.incompatible line 13
model A
  Real x = 1;
end A;
model B
  Real x = 1;
  Real y = 2;
end B;
model Base
  replaceable model M = B;
end Base;
model Test
  extends Base(redeclare model M = A);
end Test;
