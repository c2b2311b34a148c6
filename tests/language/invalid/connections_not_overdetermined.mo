// error: connections.not-overdetermined line 9 names p.v
connector Plug
  Real v;
  flow Real i;
end Plug;
model Test
  Plug p;
equation
  Connections.root(p.v);
  p.v = 1;
end Test;
