// error: redeclare.incompatible line 15 names B, Base
partial model Base
  Real x;
end Base;
model A
  extends Base(x = 1);
end A;
model B
  Real z = 2;
end B;
model C
  replaceable A a constrainedby Base;
end C;
model Test
  C c(redeclare B a);
end Test;
