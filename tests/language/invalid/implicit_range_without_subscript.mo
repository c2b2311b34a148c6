// error: for.implicit-range line 5 names i says no subscript
model Test
  Real x[3];
equation
  for i loop
    x = fill(i, 3);
  end for;
end Test;
