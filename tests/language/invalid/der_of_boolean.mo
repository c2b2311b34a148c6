// error: type.der line 4 names b
model Test
  Boolean b = time > 1;
  Real x = der(b);
end Test;
