// error: type.array-size line 5 names x[1]
model Test
  Real x[2];
algorithm
  x := {1, 2, 3};
end Test;
