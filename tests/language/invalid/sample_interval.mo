// error: call.sample line 3 says must be positive
model Test
  Boolean b = sample(0, 0);
end Test;
