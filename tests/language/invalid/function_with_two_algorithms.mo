// error: function.section line 7 names f
function f
  input Real u;
  output Real y;
algorithm
  y := u;
algorithm
  y := y + 1;
end f;
model Test
  Real x = f(1);
end Test;
