// error: if.unbalanced line 6 names time
model Test
  Real x;
  Real y;
equation
  if time > 1 then
    x = 1;
    y = 1;
  else
    x = 2;
  end if;
end Test;
