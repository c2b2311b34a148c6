// error: type.not-boolean line 3 names x
model Test
  Real x = if time then 1 else 2;
end Test;
