// error: when.if-branches line 6 names y
model Test
  Real x = time, y(start = 0);
equation
  when x > 1 then
    if x > 2 then
      y = x;
    end if;
  end when;
end Test;
