// error: stream.flow-variable line 8 names c
connector C
  Real p;
  Real m;
  stream Real h;
end C;
model Test
  C c;
  Real x = inStream(c.h);
equation
  c.p = 1;
  c.m = 1;
  c.h = 1;
end Test;
