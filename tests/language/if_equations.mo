// Conditions on parameters decide, those on variables become if-expressions.
model Test
  parameter Integer kind = 2;
  Real x;
  Real y;
  Real z;
equation
  if kind == 1 then
    x = 1;
  elseif kind == 2 then
    x = time;
    if kind > 5 then
      y = 3;
    end if;
  else
    x = 3;
  end if;
  if kind < 5 then
    y = 7;
  end if;
  if x > 1 then
    z = 1;
    assert(y > 0, "y must be positive");
  elseif x > 0.5 then
    z = 2 * x;
  else
    2 * z = x;
    assert(x < 9, "x is large", AssertionLevel.warning);
  end if;
end Test;
