// error: connect.not-a-connector line 4 names x
model Test
  Real x = 1;
  Integer n = cardinality(x);
end Test;
