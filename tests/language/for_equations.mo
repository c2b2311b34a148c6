// Nested loops, loops over vectors, an index that hides a variable.
model Test
  parameter Integer n = 2;
  Real a[n, n];
  Real b[3];
  Real i = 5;
equation
  for i in 1:n, j in 1:n loop
    a[i, j] = i + 10 * j + time;
  end for;
  for k in {3, 1, 2} loop
    b[k] = k * i;
  end for;
end Test;
