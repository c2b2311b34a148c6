// error: expandable.kind line 9 names bus, c
expandable connector Bus
end Bus;
connector C
  Real v;
  flow Real i;
end C;
model Test
  Bus bus;
  C c;
equation
  connect(c, bus);
end Test;
