// error: lookup.unknown-name line 5 names z
model Test
  Real y;
algorithm
  z := 2; y := z;
end Test;
