// error: type.array-size line 3 names x[1]
model Test
  Real x[3] = {1, 2};
end Test;
