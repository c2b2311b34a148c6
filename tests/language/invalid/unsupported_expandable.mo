// error: unsupported.expandable line 5 names bus
expandable connector Bus
end Bus;
model Test
  Bus bus;
end Test;
