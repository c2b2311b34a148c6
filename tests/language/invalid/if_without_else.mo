// error: if.unbalanced line 5 names time
model Test
  Real x;
equation
  if time > 1 then
    x = 1;
  end if;
end Test;
