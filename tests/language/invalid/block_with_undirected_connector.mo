// error: connector.undirected line 7 names b.c.v
connector Pin
  Real v;
  flow Real i;
end Pin;
block B
  Pin c;
equation
  c.v = 1;
end B;
model Test
  B b;
end Test;
