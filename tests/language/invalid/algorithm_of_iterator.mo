// error: statement.iterator line 6 names i
model Test
  Real y;
algorithm
  for i in 1:3 loop
    i := 2; y := i;
  end for;
end Test;
