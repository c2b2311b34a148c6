// error: call.function-argument line 10 names f
partial function Scalar
  input Real u;
  output Real y;
end Scalar;
function apply
  input Scalar f; output Real y = f(1);
end apply;
model Test
  Real x = apply(1 + 2);
end Test;
