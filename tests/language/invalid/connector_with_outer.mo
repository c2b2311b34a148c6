// error: class.component line 3 names v
connector Pin
  outer Real v;
  flow Real i;
end Pin;
model Test
  inner Real v = 1;
  Pin p;
end Test;
