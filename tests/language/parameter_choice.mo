// Each of two parameters from the other one, by a choice: no circle.
model Test
  parameter Boolean warm = true annotation(Evaluate = true);
  parameter Boolean tunable = false;
  parameter Real T = if warm then 300 else h / 4200;
  parameter Real h = if warm then 4200 * T else 1e5;
  parameter Real a = if tunable then 1 else b;
  parameter Real b = if tunable then a else 3;
  Real x(start = h, fixed = true);
equation
  der(x) = T - x;
end Test;
