// A later size may depend on an earlier one of the same array.
model Test
  parameter Real A[:, size(A, 1)] = {{1, 2}, {3, 4}};
  Real x[size(A, 1)](start = {1, 2});
equation
  der(x) = A * x;
end Test;
