// error: redeclare.incompatible line 13 names A, B
model A
  Real x = 1;
end A;
model B
  Real x = 1;
  Real y = 2;
end B;
model Base
  replaceable B b constrainedby B;
end Base;
model Test
  extends Base(redeclare replaceable B b constrainedby A);
end Test;
