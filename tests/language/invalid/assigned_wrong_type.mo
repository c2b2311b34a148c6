// error: type.mismatch line 6 names y
function f
  input Real u;
  output Integer y;
algorithm
  y := u;
end f;
model Test
  Real x = f(time);
end Test;
