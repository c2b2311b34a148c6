// error: inner.incompatible line 3 names a.t, t
model A
  outer Real t[3];
end A;
model Test
  inner Real t[2] = {1, 2};
  A a;
end Test;
