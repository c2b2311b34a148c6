// error: type.not-boolean line 5 names x
model Test
  Real x = time, y;
equation
  when x then
    y = x;
  end when;
end Test;
