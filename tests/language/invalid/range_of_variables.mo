// error: for.range line 5 names k[1]
model Test
  Integer k[2] = {1, integer(time)}; Real x[2];
equation
  for i in k loop
    x[i] = i;
  end for;
end Test;
