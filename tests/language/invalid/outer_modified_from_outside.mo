// error: inner.outer-modified line 7 names a.p
model A
  outer parameter Real p;
end A;
model Test
  inner parameter Real p = 1;
  A a(p = 2);
end Test;
