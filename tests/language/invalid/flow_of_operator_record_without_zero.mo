// error: component.flow-record line 8 names i, Pair
operator record Pair
  Real x;
  Real y;
end Pair;
connector Pin
  Pair e;
  flow Pair i;
end Pin;
model Test
  Pin p;
equation
  p.e = p.i;
end Test;
