// error: call.arguments line 8 names w
function f
  input Real u;
  output Real y = u;
algorithm
end f;
model Test
  Real x = f(w = 1);
end Test;
