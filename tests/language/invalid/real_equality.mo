// error: type.real-equality line 4 names x
model Test
  Real x = time;
  Real y = if x == 1 then 1 else 2;
end Test;
