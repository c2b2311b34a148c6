// error: call.element-wise line 13 names swap
function swap
  input Real u;
  input Real v;
  output Real x = v;
  output Real y = u;
algorithm
end swap;
model Test
  Real a[2];
  Real b[2];
equation
  (a, b) = swap({1, 2}, {3, 4});
end Test;
