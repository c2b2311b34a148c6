// error: inner.incompatible line 3 names a.t, t
model A
  outer Integer t;
end A;
model Test
  inner Real t = 1;
  A a;
end Test;
