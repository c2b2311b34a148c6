// error: lookup.protected line 8 names a.x
model A
protected
  Real x = 1;
end A;
model Test
  A a;
  Real y = a.x;
end Test;
