// error: function.section line 5 names f
function f
  input Real u;
  output Real y = u;
initial algorithm
  y := u;
end f;
model Test
  Real x = f(1);
end Test;
