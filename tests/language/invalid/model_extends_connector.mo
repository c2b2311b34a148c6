// error: extends.kind line 7 names Test, Pin
connector Pin
  Real v;
  flow Real i;
end Pin;
model Test
  extends Pin(v = 1);
end Test;
