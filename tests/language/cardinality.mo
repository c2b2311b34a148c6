connector Pin
  Real v;
  flow Real i;
end Pin;

model Part
  Pin p;
  Pin n;
  Real count = cardinality(p);
equation
  assert(cardinality(n) <= 2, "too many connections");
  if cardinality(n) == 0 then
    n.v = 0;
  else
    p.i + n.i = 0;
  end if;
  p.v - n.v = p.i;
end Part;

model Shell "whether there is an outer pin or an own one, the part inside is connected once"
  parameter Boolean open = false;
  Pin outside if open;
  Part own if not open;
  Part inside;
equation
  connect(inside.p, outside);
  connect(own.p, inside.p);
end Shell;

model Test "cardinality counts the connections inside and outside of a component"
  Part a;
  Part b;
  Part c;
  Shell shell;
equation
  connect(a.p, b.p);
  connect(a.p, c.p);
  connect(b.n, a.n);
end Test;
