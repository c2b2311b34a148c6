// error: component.prefix line 6 names m
model M
  Real x = 1;
end M;
model Test
  parameter M m;
end Test;
