// error: lookup.unknown-field line 9 names b
record R
  Real a;
end R;
function f
  input R r;
  output Real y;
algorithm
  y := r.b;
end f;
model Test
  Real x = f(R(1));
end Test;
