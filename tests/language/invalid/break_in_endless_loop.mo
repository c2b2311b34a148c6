// error: unsupported.run-time-loop line 7
model Test
  Real y;
algorithm
  y := time;

  while true loop y := y / 2; if y < 1 then break; end if; end while;
end Test;
