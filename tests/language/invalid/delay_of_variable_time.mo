// error: call.variability line 3 names x
model Test
  Real x = time; Real y = delay(x, x);
end Test;
