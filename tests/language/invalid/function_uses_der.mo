// error: function.operator line 6 names f, der
function f
  input Real u;
  output Real y;
algorithm
  y := der(u);
end f;
model Test
  Real x = f(time);
end Test;
