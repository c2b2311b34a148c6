// error: when.branches line 9 names z
model Test
  Real x = time, y, z;
  Boolean b = x > 2;
equation
  when x > 1 then
    y = x;
    z = 1;
  elsewhen b then
    y = 2;
  end when;
end Test;
