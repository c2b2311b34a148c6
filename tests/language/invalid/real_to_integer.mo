// error: type.mismatch line 3 names n
model Test
  parameter Integer n = 1.5;
end Test;
