// error: extends.kind line 6 names f, R
record R
  input Real u;
end R;
function f
  extends R;
  output Real y = 1;
algorithm
end f;
model Test
  Real y = f(1);
end Test;
