// error: stream.type line 5 names c.n
connector C
  Real p;
  flow Real m;
  stream Integer n;
end C;
model Test
  C c;
end Test;
