// error: component.nested-prefix line 4 names p.i
connector Pin
  Real v;
  flow Real i;
end Pin;
model Test
  input Pin p;
end Test;
