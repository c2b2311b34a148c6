// error: redeclare.incompatible line 16 names A, B
model A
  Real x = 1;
end A;
model B
  Real x = 1;
  Real y = 2;
end B;
model Base
  replaceable A a;
end Base;
model Middle
  extends Base(redeclare replaceable B a constrainedby B);
end Middle;
model Test
  extends Middle(redeclare A a);
end Test;
