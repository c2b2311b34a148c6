// error: unsupported.run-time-loop line 7 names halved
function halved
  input Real u;
  output Real y;
algorithm
  y := u;
  while y > 1 loop
    y := y / 2;
  end while;
end halved;
model Test
  Real x = halved(time);
end Test;
