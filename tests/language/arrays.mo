// Sizes by parameters, slices, ranges, end, constructors, comprehensions.
model Test
  parameter Integer n = 3;
  Real a[n];
  Real b[n, 2];
  parameter Real c[:] = {i ^ 2 for i in 1:n};
  parameter Real d[:, :] = [1, 2; 3, 4];
  parameter Integer size_of_d = size(d, 1) + ndims(d);
  Real e[2] = a[{1, end}];
  Real last = b[end, end - 1];
  parameter Real steps[:] = 0:0.25:1;
  parameter Real table[2, 3] = {10 * i + j for j in 1:3, i in 1:2};
equation
  a[1:2] = {time, 2};
  a[end] = 0;
  for i in 1:n loop
    b[i, :] = {a[i], i};
  end for;
end Test;
