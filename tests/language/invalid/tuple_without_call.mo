// error: equation.tuple line 6
model Test
  Real x;
  Real y;
equation
  (x, y) = {1, 2};
end Test;
