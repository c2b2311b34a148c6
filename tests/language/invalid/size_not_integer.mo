// error: array.bad-size line 3 names x
model Test
  Real x[2.5];
end Test;
