// semiLinear element by element, a scalar beside arrays; and of arrays without elements.
model Test
  parameter Integer n = 0;
  Real x = time - 1;
  Real a[2] = {1, 2} * time;
  Real y[2] = semiLinear(x, a, {3, 4});
  Real empty[n] = semiLinear(x, fill(1.0, n), zeros(n));
end Test;
