// Potentials of a set are equal, flows sum to zero; parts count positive, own connectors negative (9.2).
connector Pin
  Real v;
  flow Real i;
end Pin;
model Resistor
  Pin p;
  Pin n;
equation
  p.v - n.v = 2 * p.i;
  p.i + n.i = 0;
end Resistor;
model Ground
  Pin p;
equation
  p.v = 0;
end Ground;
model Pair
  Pin p;
  Pin n;
  Resistor a;
  Resistor b;
equation
  connect(p, a.p);
  connect(a.n, b.p);
  connect(b.n, n);
end Pair;
model Test
  Pair pair;
  Resistor r;
  Ground g;
  Resistor open;
equation
  connect(g.p, pair.n);
  connect(pair.p, r.p);
  connect(r.n, g.p);
  connect(open.n, g.p);
end Test;
