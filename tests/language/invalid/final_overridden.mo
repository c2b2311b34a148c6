// error: modification.final line 6 names a.p
model A
  final parameter Real p = 1;
end A;
model Test
  A a(p = 2);
end Test;
