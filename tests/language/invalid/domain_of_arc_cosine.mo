// error: call.domain line 3 names acos
model Test
  Real x[2] = acos({0.5, 1.5});
end Test;
