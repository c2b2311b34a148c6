// error: parameter.arithmetic line 4 names b
model Test
  parameter Integer a = 2000000000;
  parameter Integer b = a * a * a * a;
  Real x[b];
end Test;
