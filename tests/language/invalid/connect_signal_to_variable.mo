// error: connect.mismatch line 19 names m.a.x, m.b.x
connector A
  input Real x;
  Real e;
  flow Real f;
end A;
connector B
  Real x;
  output Real e;
  flow Real f;
end B;
model M
  A a;
  B b;
end M;
model Test
  M m;
equation
  connect(m.a, m.b);
  m.a.x = 1;
  m.a.e = 2;
end Test;
