// A function may give a number another unit: its declared result counts, not what it is made of.
model Test
  function direction "A vector of lengths as plain numbers"
    input Real r[2];
    output Real e[2](each unit = "1");
  algorithm
    e := r;
  end direction;

  function doubled
    input Real r(unit = "m");
    output Real n(unit = "1");
  algorithm
    n := 2*r;
  end doubled;

  parameter Real r[2](each unit = "m") = {1, 2};
  parameter Real s[2](each unit = "m") = {3, 4};
  Real e[2](each unit = "1") = direction(r - s);
  Real n(unit = "1") = doubled(r[1]);
end Test;
