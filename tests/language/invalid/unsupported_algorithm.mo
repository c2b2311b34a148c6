// error: unsupported.algorithm line 4 names Test
model Test
  Real x;
algorithm
  x := time;
end Test;
