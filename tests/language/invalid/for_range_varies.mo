// error: for.range line 6 names y[1]
model Test
  Integer x[2];
  Integer y[2] = {1, 2};
equation
  for i in y loop
    x[i] = 1;
  end for;
end Test;
