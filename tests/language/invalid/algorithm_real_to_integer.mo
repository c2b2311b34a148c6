// error: type.mismatch line 5 names n
model Test
  Integer n;
algorithm
  n := time;
end Test;
