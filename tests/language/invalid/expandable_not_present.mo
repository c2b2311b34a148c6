// error: expandable.not-present line 8 names bus.x
expandable connector Bus
  Real x;
end Bus;

model Test
  Bus bus;
  Real y = bus.x;
end Test;
