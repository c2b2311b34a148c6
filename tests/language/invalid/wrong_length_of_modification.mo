// error: type.array-size line 6 names a[1].p
model A
  parameter Real p = 1;
end A;
model Test
  A a[3](p = {1, 2});
end Test;
