// error: modification.missing-each line 3 names x[1]
model Test
  Real x[2](start = 1) = {1, 2};
end Test;
