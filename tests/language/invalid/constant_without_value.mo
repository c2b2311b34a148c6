// error: constant.no-value line 3 names k
model Test
  constant Real k;
  Real x = k;
end Test;
