// error: call.arguments line 3 names x
model Test
  Real x = sin(1, 2);
end Test;
