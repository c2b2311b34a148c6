// error: for.too-long line 5
model Test
  Real x;
equation
  for i in 1:2000000000 loop
    x = i;
  end for;
end Test;
