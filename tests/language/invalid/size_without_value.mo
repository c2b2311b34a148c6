// error: parameter.no-value line 3 names n
model Test
  parameter Integer n;
  Real x[n];
end Test;
