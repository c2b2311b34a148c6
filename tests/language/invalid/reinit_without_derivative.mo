// error: reinit.state line 7 names y says derivative
model Test
  Real x(start = 1), y;
equation
  der(x) = -x;
  y = 2 * x;
  when x < 0.5 then reinit(y, 2); end when;
end Test;
