// error: equation.conditional-when line 6 says condition known at compile time
model Test
  Real x = time, y;
equation
  if x > 1 then
    when x > 2 then
      y = x;
    end when;
  else
    y = 1;
  end if;
end Test;
