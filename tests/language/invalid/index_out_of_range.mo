// error: type.index-out-of-range line 4 names x
model Test
  Real x[3] = {1, 2, 3};
  Real y = x[4];
end Test;
