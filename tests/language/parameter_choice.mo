// Each of two parameters from the other one, by a choice that is evaluated: no circle.
model Test
  parameter Boolean warm = true annotation(Evaluate = true);
  parameter Real T = if warm then 300 else h / 4200;
  parameter Real h = if warm then 4200 * T else 1e5;
  Real x(start = h, fixed = true);
equation
  der(x) = T - x;
end Test;
