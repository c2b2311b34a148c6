// Branches whose sizes differ: parameters decide, and become structural.
model Test
  parameter Integer n = 2;
  parameter Real table[:, 2] = if n > 1 then {{1, 2}, {3, 4}} else {{0, 0}};
  parameter Real pick = if n > 2 then table[3, 1] else table[2, 1];
  Real x[n] = table[:, 1];
end Test;
