// error: call.function-argument line 15 names f
partial function Scalar
  input Real u;
  output Real y;
end Scalar;
function two
  input Real u;
  input Real v;
  output Real y = u + v;
end two;
function apply
  input Scalar f; output Real y = f(1);
end apply;
model Test
  Real x = apply(two);
end Test;
