// error: structural.not-constant line 4 names n
model Test
  Integer n = integer(time);
  Real x[n];
end Test;
