// error: reinit.several line 6 names x
model Test
  Real x(start = 1);
equation
  der(x) = -x;
  when x < 0.5 then reinit(x, 2); end when; when time > 3 then reinit(x, 3); end when;
end Test;
