// error: array.bad-size line 3 names x
model Test
  Real x[100000, 100000];
end Test;
