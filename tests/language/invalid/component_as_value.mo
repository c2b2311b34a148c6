// error: type.component-as-value line 7 names a
model A
  Real x = 1;
end A;
model Test
  A a;
  Real y = a;
end Test;
