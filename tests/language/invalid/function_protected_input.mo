// error: class.component line 5 names u
function f
  output Real y;
protected
  input Real u = 1;
algorithm
  y := u;
end f;
model Test
  Real x = f();
end Test;
