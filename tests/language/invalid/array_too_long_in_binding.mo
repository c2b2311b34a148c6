// error: type.array-size line 3 names x[1]
model Test
  parameter Real x[2] = {1, 2, 3};
end Test;
