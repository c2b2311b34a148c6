// error: type.not-numeric line 3 names x
model Test
  Real x = sin(true);
end Test;
