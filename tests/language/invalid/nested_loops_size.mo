// error: for.too-long line 4 names j says more than 200000
model Test
equation
  for i in 1:1000, j in 1:1000 loop
    assert(i + j > 0, "never");
  end for;
end Test;
