// error: lookup.unknown-name line 9 names q
connector Pin
  Real v;
  flow Real i;
end Pin;
model Test
  Pin p;
equation
  connect(p, q);
end Test;
