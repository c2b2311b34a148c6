// error: function.unassigned line 4 names y
function f
  input Real u;
  output Real y;
protected
  Real z;
algorithm
  z := u;
end f;
model Test
  Real x = f(time);
end Test;
