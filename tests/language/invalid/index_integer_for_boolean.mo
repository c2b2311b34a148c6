// error: type.index line 4 names x
model Test
  Real x[Boolean] = {1, 2};
  Real y = x[2];
end Test;
