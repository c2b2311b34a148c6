// error: structural.not-constant line 5 names i
model Test
  Real x[3] = {1, 2, 3};
  Integer i = integer(time);
  Real y = x[i];
end Test;
