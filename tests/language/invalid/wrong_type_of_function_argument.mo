// error: type.mismatch line 8 names u
function f
  input Real u;
  output Real y = u;
algorithm
end f;
model Test
  Real x = f("one");
end Test;
