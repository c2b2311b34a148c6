// error: parameter.cyclic line 3 names a, b
model Test
  parameter Integer a = b + 1;
  parameter Integer b = 2 * a;
  Real x[a];
end Test;
