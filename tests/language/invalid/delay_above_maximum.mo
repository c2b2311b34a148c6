// error: call.delay line 3 says larger than its maximum
model Test
  Real y = delay(time, 2, 1);
end Test;
