// error: function.assignment line 6 names u
function f
  input Real u;
  output Real y;
algorithm
  u := 1;
  y := u;
end f;
model Test
  Real x = f(time);
end Test;
