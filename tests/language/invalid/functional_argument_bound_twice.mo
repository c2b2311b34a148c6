// error: call.arguments line 13 names v
partial function Scalar
  input Real u;
  output Real y;
end Scalar;
function two
  input Real u; input Real w; output Real y = u + w;
end two;
function apply
  input Scalar f; output Real y = f(1);
end apply;
model Test
  Real x = apply(function two(v = 1));
end Test;
