// error: type.array-size line 5 names x[1], x[2], x[3]
model Test
  Real x[3];
equation
  x = {1, 2};
end Test;
