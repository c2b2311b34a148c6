// error: array.bad-size line 3 names s
model Test
  parameter Real s = sum(fill(1.0, 50000, 50000));
  Real x = s;
end Test;
