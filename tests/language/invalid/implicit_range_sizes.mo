// error: for.implicit-range line 5 names i says different sizes
model Test
  Real x[3], y[2];
equation
  for i loop
    x[i] = time; y[i] = i;
  end for;
end Test;
