// error: unsupported.run-time-loop line 6
model Test
  Real y;
algorithm
  y := time;
  while y > 1 loop y := y / 2; end while;
end Test;
