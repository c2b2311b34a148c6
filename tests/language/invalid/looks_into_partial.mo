// error: lookup.partial line 6 names P.c
partial package P
  constant Real c = 1;
end P;
model Test
  Real x = P.c;
end Test;
