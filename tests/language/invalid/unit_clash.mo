// error: unit.clash line 6 names t, l
model Test
  Real l(unit = "m") = 1;
  Real t(unit = "s");
equation
  t = l;
end Test;
