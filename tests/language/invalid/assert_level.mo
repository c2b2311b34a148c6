// error: type.mismatch line 5
model Test
  Real x = 1;
equation
  assert(x > 0, "text", 3);
end Test;
