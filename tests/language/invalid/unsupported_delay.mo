// error: unsupported.delay line 3 names delay
model Test
  Real x = delay(time, 1);
end Test;
