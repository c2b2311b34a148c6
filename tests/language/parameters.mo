// Parameters and constants depend on each other in any order; Integer values fit Real parameters.
model Test
  parameter Real a = 2 * b;
  parameter Real b = c + 1;
  constant Real c = 3;
  parameter Integer n = 2;
  parameter Boolean on = n > 1;
  parameter String text = "a" + "b";
  parameter Real open(start = 4);
  final parameter Real f = a;
  Real x = a;
end Test;
