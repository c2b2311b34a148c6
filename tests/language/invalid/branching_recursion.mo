// error: function.recursion line 6 names f
function f
  input Real u;
  output Real y;
algorithm
  y := f(u - 1) + f(u - 2);
end f;
model Test
  Real x = f(time);
end Test;
