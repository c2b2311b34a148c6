// error: type.not-numeric line 3 names x
model Test
  Real x = 1 + (time > 1);
end Test;
