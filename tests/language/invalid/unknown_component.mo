// error: lookup.unknown-name line 7 names a.z
model A
  Real x = 1;
end A;
model Test
  A a;
  Real y = a.z;
end Test;
