// error: connect.mismatch line 19 names m.a.n, m.b.n
connector C
  constant Integer n = 1;
  Real v;
  flow Real i;
end C;
connector P
  parameter Integer n = 1;
  Real v;
  flow Real i;
end P;
model M
  C a;
  P b;
end M;
model Test
  M m;
equation
  connect(m.a, m.b);
end Test;
