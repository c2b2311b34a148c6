// error: type.mismatch line 6 names x, b
model Test
  Real x;
  Boolean b = time > 1;
equation
  x = b;
end Test;
