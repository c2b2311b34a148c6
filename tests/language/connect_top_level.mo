// The model's own connectors: connected inside, not connected outside.
connector Pin
  Real v;
  flow Real i;
end Pin;
model Resistor
  Pin p;
  Pin n;
equation
  p.v - n.v = p.i;
  p.i + n.i = 0;
end Resistor;
model Test
  Pin p;
  Pin n;
  Pin unused;
  Resistor r;
equation
  connect(p, r.p);
  connect(r.n, n);
  unused.v = 3;
end Test;
