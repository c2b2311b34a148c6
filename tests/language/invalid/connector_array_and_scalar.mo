// error: connect.mismatch line 10 names a, b says different sizes: [2] and []
connector Pin
  Real v;
  flow Real i;
end Pin;
model Test
  Pin a[2];
  Pin b;
equation
  connect(a, b);
end Test;
