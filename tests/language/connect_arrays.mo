// Arrays of connectors and loops of connect equations.
connector Pin
  Real v;
  flow Real i;
end Pin;
model Cell
  Pin p;
  Pin n;
equation
  p.v - n.v = p.i;
  p.i + n.i = 0;
end Cell;
model Test
  parameter Integer n = 3;
  Cell cell[n];
  Pin ends[2];
equation
  for i in 1:n - 1 loop
    connect(cell[i].n, cell[i + 1].p);
  end for;
  connect(ends[1], cell[1].p);
  connect(ends[2], cell[n].n);
end Test;
