// error: lookup.unknown-name line 4 names x.z
model Test
  Real x = 1;
  Real y = x.z;
end Test;
