// error: connect.mismatch line 14 names p[1], f says only one of them has `v`
connector Pin
  Real v;
  flow Real i;
end Pin;
connector Flange
  Real phi;
  flow Real tau;
end Flange;
model Test
  Pin p[2];
  Flange f;
equation
  connect(p, f);
end Test;
