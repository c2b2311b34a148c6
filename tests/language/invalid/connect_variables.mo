// error: connect.not-a-connector line 6 names x
model Test
  Real x = 1;
  Real y;
equation
  connect(x, y);
end Test;
