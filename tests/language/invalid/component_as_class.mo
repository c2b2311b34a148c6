// error: lookup.not-a-class line 4 names x
model Test
  Real x = 1;
  x y;
end Test;
