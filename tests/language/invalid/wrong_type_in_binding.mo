// error: type.mismatch line 3 names x
model Test
  Real x = true;
end Test;
