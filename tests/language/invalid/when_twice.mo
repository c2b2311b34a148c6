// error: when.twice line 7 names y
model Test
  Real x = time, y;
equation
  when x > 1 then
    y = x;
    y = 2 * x;
  end when;
end Test;
