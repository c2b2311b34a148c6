// error: modification.duplicate line 6 names p
model A
  parameter Real p = 1;
end A;
model Test
  A a(p = 2, p = 3);
end Test;
