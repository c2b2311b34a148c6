// error: parameter.cyclic line 4 names x
model Test
  parameter Integer n = size(x, 1);
  Real x[n];
end Test;
