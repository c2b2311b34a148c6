// error: call.arguments line 8 names u
function f
  input Real u;
  output Real y = u;
algorithm
end f;
model Test
  Real x = f(1, u = 2);
end Test;
