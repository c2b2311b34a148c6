// error: stream.no-stream line 9 names inStream says `c.p` is none
connector C
  Real p;
  flow Real m;
  stream Real h;
end C;
model Test
  C c;
  Real x = inStream(c.p);
equation
  c.p = 1;
  c.h = 1;
end Test;
