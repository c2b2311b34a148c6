// error: unsupported.implicit-range line 5 names i
model Test
  Real x[3];
equation
  for i loop
    x[i] = i;
  end for;
end Test;
