// error: function.public line 5 names f, half
function f
  input Real u;
  output Real y;
  Real half;
algorithm
  half := u/2;
  y := half;
end f;
model Test
  Real x = f(1);
end Test;
