// error: connect.mismatch line 14 names p.i, s.i
connector Pin
  Real v;
  flow Real i;
end Pin;
connector Sense
  Real v;
  Real i;
end Sense;
model Test
  Pin p;
  Sense s;
equation
  connect(p, s);
end Test;
