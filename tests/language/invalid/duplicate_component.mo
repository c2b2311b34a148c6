// error: lookup.duplicate-element line 4 names x
model Test
  Real x = 1;
  Integer x = 2;
end Test;
