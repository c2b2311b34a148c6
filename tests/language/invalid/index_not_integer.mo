// error: type.subscript line 4 names x
model Test
  Real x[3] = {1, 2, 3};
  Real y = x[1.5];
end Test;
