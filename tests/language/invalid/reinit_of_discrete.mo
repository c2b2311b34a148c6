// error: reinit.state line 7 names n
model Test
  Integer n;
  Real x(start = 1);
equation
  der(x) = -x;
  when x < 0.5 then reinit(n, 2); n = 1; end when;
end Test;
