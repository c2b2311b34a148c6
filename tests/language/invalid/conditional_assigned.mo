// error: lookup.conditional line 5 names x
model Test
  Real x if true;
algorithm
  x := 1;
end Test;
