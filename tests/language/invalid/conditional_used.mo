// error: lookup.conditional line 7 names a
model A
  Real x = 1;
end A;
model Test
  A a if false;
  Real y = a.x;
end Test;
