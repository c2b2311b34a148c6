// error: parameter.arithmetic line 3 names p
model Test
  parameter Real p = sqrt(-1);
  Real x[integer(p)];
end Test;
