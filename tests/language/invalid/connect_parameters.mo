// error: connect.constant line 10 names a.n, b.n
connector C
  parameter Integer n = 1;
  Real v;
end C;
model Test
  C a(n = 1);
  C b(n = 2);
equation
  connect(a, b);
  a.v = 1;
end Test;
