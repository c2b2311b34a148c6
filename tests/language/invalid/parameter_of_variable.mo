// error: flat.variability line 4 names p, x
model Test
  Real x = time;
  parameter Real p = x;
end Test;
