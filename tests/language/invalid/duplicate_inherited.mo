// error: lookup.duplicate-element line 6 names x
model A
  Real x = 1;
end A;
model B
  Integer x = 1;
end B;
model Test
  extends A;
  extends B;
end Test;
