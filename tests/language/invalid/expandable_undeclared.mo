// error: expandable.undeclared line 9 names a.x, b.x
expandable connector Bus
end Bus;

model Test
  Bus a;
  Bus b;
equation
  connect(a.x, b.x);
end Test;
