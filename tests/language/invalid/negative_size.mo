// error: array.bad-size line 4 names x
model Test
  parameter Integer n = -1;
  Real x[n];
end Test;
