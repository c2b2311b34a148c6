// error: type.partial line 7 names f
partial function f
  input Real u;
  output Real y;
end f;
model Test
  Real x = f(1);
end Test;
