// error: component.kind line 6 names part
model Part
  Real x = 1;
end Part;
record R
  Part part;
end R;
model Test
  R r;
end Test;
