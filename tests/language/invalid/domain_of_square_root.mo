// error: call.domain line 5 names sqrt
model Test
  Real x;
equation
  x = sqrt(-4);
end Test;
