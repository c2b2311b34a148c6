// error: connect.mismatch line 14 names p, f
connector Pin
  Real v;
  flow Real i;
end Pin;
connector Flange
  Real phi;
  flow Real tau;
end Flange;
model Test
  Pin p;
  Flange f;
equation
  connect(p, f);
end Test;
