// error: unsupported.call-equation line 5 names reinit
model Test
  Real x;
equation
  reinit(x, 1);
end Test;
