// All attributes reach the flat model.
model Test
  parameter Real m(unit = "m", quantity = "Length", min = 0, max = 10) = 1 "a length";
  Real x(start = m, fixed = true, nominal = 2 * m, stateSelect = StateSelect.prefer, displayUnit = "mm",
    unit = "m");
  Integer n(start = 3, min = 1) = 4;
  Boolean b(start = true) = time > 1;
equation
  der(x) = 0;
end Test;
