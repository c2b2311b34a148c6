// error: type.mismatch line 3 names x
model Test
  Real x(start = "zero") = 1;
end Test;
