// error: call.no-value line 3 names assert
model Test
  Real x = assert(true, "no value");
end Test;
