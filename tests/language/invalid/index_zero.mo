// error: type.index-out-of-range line 5 names x
model Test
  parameter Integer i = 0;
  Real x[3] = {1, 2, 3};
  Real y = x[i];
end Test;
