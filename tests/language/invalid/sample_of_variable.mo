// error: call.variability line 3 names x
model Test
  Real x = time; Boolean b = sample(0, x);
end Test;
