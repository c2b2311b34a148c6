// error: call.delay line 3 says cannot be negative
model Test
  Real y = delay(time, -1);
end Test;
