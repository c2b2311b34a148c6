// error: type.not-array line 4 names x
model Test
  Real x = 1;
  Real y = x[1];
end Test;
