// error: lookup.unknown-modified-element line 6 names y
model A
  Real x = 1;
end A;
model Test
  extends A(y = 2);
end Test;
