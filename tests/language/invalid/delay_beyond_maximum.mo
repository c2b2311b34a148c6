// error: call.delay line 6
model Test
  Real x = time;
  Real y;
equation
  y = delay(x, 2, 1);
end Test;
