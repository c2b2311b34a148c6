// error: lookup.protected line 7 names a.p
model A
protected
  parameter Real p = 1;
end A;
model Test
  A a(p = 2);
end Test;
