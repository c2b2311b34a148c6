// error: array.bad-size line 4 says 1000000 multiplications
model Test
  parameter Real a[101, 101] = fill(1.0, 101, 101);
  Real x = sum(a*a);
end Test;
