// error: parameter.arithmetic line 4 names p
model Test
  parameter Real q = -1;
  parameter Real p = sqrt(q);
  Real x[integer(p)];
end Test;
