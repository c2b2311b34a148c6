// error: modification.missing-each line 3 names x[1]
model Test
  Real x[3] = 1;
end Test;
