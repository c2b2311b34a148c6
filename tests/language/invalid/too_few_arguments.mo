// error: call.arguments line 9 names v
function f
  input Real u;
  input Real v;
  output Real y = u + v;
algorithm
end f;
model Test
  Real x = f(1);
end Test;
