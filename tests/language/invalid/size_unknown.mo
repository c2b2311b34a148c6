// error: array.unknown-size line 3 names x
model Test
  Real x[:];
end Test;
