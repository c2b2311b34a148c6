// error: unsupported.sample line 3 names sample
model Test
  Boolean b = sample(0, 1);
end Test;
