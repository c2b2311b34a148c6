// error: function.recursion line 4 names g
function f
  input Real u;
  output Real y = g(u);
algorithm
end f;
function g
  input Real u;
  output Real y = f(u);
algorithm
end g;
model Test
  Real x = f(time);
end Test;
