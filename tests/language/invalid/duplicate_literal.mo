// error: lookup.duplicate-element line 3 names a
model Test
  type E = enumeration(a, b, a);
  parameter E e = E.a;
end Test;
