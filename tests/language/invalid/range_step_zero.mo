// error: type.range line 3 names x
model Test
  Real x = sum(i for i in 1:0:3);
end Test;
