// error: lookup.conditional line 5 names x
model Test
  parameter Boolean on = true;
  Real x = 2 if on;
  Real y = 3*x;
end Test;
