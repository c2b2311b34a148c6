// error: type.der line 4 names n
model Test
  Integer n = 1;
  Real x = der(n);
end Test;
