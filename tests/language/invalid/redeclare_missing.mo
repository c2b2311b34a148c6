// error: lookup.duplicate-element line 7 names x
model A
  Real x = 1;
end A;
model Test
  extends A;
  Real x = 2;
end Test;
