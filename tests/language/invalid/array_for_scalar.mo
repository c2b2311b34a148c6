// error: type.array-size line 3 names x
model Test
  Real x = {1, 2};
end Test;
