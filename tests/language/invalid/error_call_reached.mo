// error: assertion.failed line 8 says stop here
function error
  input String text;
external "C" ModelicaError(text);
end error;
function f input Real u; output Real y;
algorithm
  error("stop here"); y := u;
end f;
model Test
  Real x = f(time);
end Test;
