// error: unsupported.run-time-loop line 6 names f
function f
  input Real u;
  output Real y = u;
algorithm
  while y > 1 loop
    y := y - 1;
  end while;
end f;
model Test
  Real x = f(time);
end Test;
