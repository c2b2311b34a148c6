// error: type.not-boolean line 5 names x
model Test
  Real x;
equation
  if x then
    x = 1;
  else
    x = 2;
  end if;
end Test;
