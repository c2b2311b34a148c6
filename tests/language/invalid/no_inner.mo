// error: unsupported.missing-inner line 3 names a.x
model A
  outer Real x;
  Real y = x;
end A;
model Test
  A a;
end Test;
