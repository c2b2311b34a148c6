// error: expandable.flow line 4 names bus.i
expandable connector Bus
  Real v;
  flow Real i;
end Bus;
model Test
  Bus bus;
end Test;
