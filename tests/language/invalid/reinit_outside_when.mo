// error: equation.reinit line 6 names reinit
model Test
  Real x(start = 1);
equation
  der(x) = 1;
  reinit(x, 2);
end Test;
