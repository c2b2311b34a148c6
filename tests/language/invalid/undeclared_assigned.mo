// error: function.assignment line 6 names z
function f
  input Real u;
  output Real y;
algorithm
  z := u;
  y := u;
end f;
model Test
  Real x = f(time);
end Test;
