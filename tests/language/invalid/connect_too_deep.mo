// error: connect.too-deep line 16 names b.a.p
connector Pin
  Real v;
  flow Real i;
end Pin;
model A
  Pin p;
end A;
model B
  A a;
end B;
model Test
  B b;
  Pin p;
equation
  connect(p, b.a.p);
end Test;
