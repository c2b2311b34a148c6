// error: call.arguments line 8 names f
function f
  input Real u;
  output Real y = u;
algorithm
end f;
model Test
  Real x = f(1, 2);
end Test;
