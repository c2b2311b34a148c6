// error: function.component line 9 names f, m
model M
  parameter Real k = 2;
end M;
function f
  input Real u;
  output Real y;
protected
  M m;
algorithm
  y := u*m.k;
end f;
model Test
  Real x = f(1);
end Test;
