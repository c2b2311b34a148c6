// error: connect.not-a-connector line 13 names a
connector Pin
  Real v;
  flow Real i;
end Pin;
model A
  Pin p;
end A;
model Test
  A a;
  A b;
equation
  connect(a, b);
end Test;
