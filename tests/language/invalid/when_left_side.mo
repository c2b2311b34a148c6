// error: equation.when-left-side line 7
model Test
  Real x;
  Real y = time;
equation
  when y > 1 then
    x + y = 2;
  end when;
end Test;
