// error: balance.local line 6 names short, Short says 2 equations for 3 unknowns
connector Pin
  Real v;
  flow Real i;
end Pin;
model Short
  Pin p;
  Real x;
equation
  p.v = 0;
end Short;
model Long
  Pin p;
  Real x;
equation
  p.v = p.i;
  x = 1;
  x = 2*p.v;
end Long;
model Test
  Short short;
  Long long;
equation
  connect(short.p, long.p);
end Test;
