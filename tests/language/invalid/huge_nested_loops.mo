// error: for.too-long line 5 names j
model Test
  Real x;
equation
  for i in 1:1000, j in 1:1000, k in 1:1000 loop
    x = i;
  end for;
end Test;
