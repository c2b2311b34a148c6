// error: connect.mismatch line 12 names a.v, b.v
connector A
  Real v;
end A;
connector B
  Integer v;
end B;
model Test
  A a;
  B b;
equation
  connect(a, b);
end Test;
