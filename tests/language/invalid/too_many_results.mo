// error: call.results line 11 names f
function f
  input Real u;
  output Real y = u;
algorithm
end f;
model Test
  Real x;
  Real z;
equation
  (x, z) = f(1);
end Test;
