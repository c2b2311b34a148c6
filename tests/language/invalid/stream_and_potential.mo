// error: connect.mismatch line 24 names a.c.h, b.d.h says one is a stream variable
connector C
  Real p;
  flow Real m;
  stream Real h;
end C;
connector D
  Real p;
  flow Real m;
  Real h;
end D;
model A
  C c;
end A;
model B
  D d;
end B;

model Test
  A a;
  B b;
equation
  // a stream variable has no potential to be equal to
  connect(a.c, b.d);
end Test;
