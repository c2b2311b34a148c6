// error: modification.final line 9 names b.a.p
model A
  parameter Real p = 1;
end A;
model B
  A a(final p = 2);
end B;
model Test
  B b(a(p = 3));
end Test;
