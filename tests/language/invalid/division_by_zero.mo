// error: parameter.arithmetic line 3 names n
model Test
  parameter Integer n = div(4, 0);
  Real x[n];
end Test;
