// error: type.der line 7 names d
model Test
  Real d, y;
equation
  when time > 1 then d = 2; end when;

  y = der(d);
end Test;
