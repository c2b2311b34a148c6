// error: class.external line 4 names M
model M
  Real x = 1;
external "C";
end M;
model Test
  M m;
end Test;
