// error: lookup.unknown-name line 5 names presure
model Test
  Real pressure;
equation
  presure = 1;
end Test;
