// error: unit.clash line 10
model Test
  function area
    input Real a(unit = "m");
    output Real s(unit = "m2");
  algorithm
    s := a*a;
  end area;
  parameter Real a(unit = "m") = 1;
  Real t(unit = "s") = area(a);
end Test;
