// error: type.mismatch line 4 says String
model Test
equation
  terminate(3);
end Test;
