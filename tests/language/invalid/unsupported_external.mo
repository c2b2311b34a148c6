// error: unsupported.external-function line 8 names f
function f
  input Real u;
  output Real y;
external "C" y = f(u);
end f;
model Test
  Real x = f(time);
end Test;
