// error: stream.place line 3 names x
model Test
  stream Real x = 1;
end Test;
