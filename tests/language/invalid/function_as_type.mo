// error: type.not-a-component-type line 8 names x
function f
  input Real u;
  output Real y = u;
algorithm
end f;
model Test
  f x;
end Test;
