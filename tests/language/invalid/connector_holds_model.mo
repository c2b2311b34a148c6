// error: component.kind line 8 names part
model Part
  Real x = 1;
end Part;
connector Pin
  Real v;
  flow Real i;
  Part part;
end Pin;
model Test
  Pin p;
equation
  p.v = 1;
end Test;
