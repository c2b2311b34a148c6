// error: parameter.arithmetic line 11 names n
function f
  input Real u;
  output Real y = u;
algorithm
  for i in 1:200 loop
    y := y * y + y;
  end for;
end f;
model Test
  parameter Integer n = integer(f(1));
  Real x[n];
end Test;
