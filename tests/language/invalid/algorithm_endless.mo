// error: function.too-long line 6 says more than
model Test
  Real y;
algorithm
  y := 1;
  while true loop y := y + 1; end while;
end Test;
