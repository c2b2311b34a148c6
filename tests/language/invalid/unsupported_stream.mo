// error: unsupported.stream line 5 names c.h
connector C
  Real p;
  flow Real m;
  stream Real h;
end C;
model Test
  C c;
end Test;
