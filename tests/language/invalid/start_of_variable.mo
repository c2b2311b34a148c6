// error: flat.variability line 4 names x, y
model Test
  Real y = time;
  Real x(start = y);
equation
  der(x) = 1;
end Test;
