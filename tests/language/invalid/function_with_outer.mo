// error: class.component line 6 names scale
function f
  input Real u;
  output Real y = scale*u;
protected
  outer Real scale;
algorithm
end f;
model Test
  inner Real scale = 2;
  Real x = f(1);
end Test;
