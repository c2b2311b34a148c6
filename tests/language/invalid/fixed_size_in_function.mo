// error: type.array-size line 7 names y
function f
  input Real u[:];
  output Real y[2];
algorithm
  y := u;
  y := cat(1, u, u);
end f;
model Test
  Real x[2] = f({1, 2});
end Test;
