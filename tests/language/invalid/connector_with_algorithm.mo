// error: class.section line 5 names Pin
connector Pin
  Real v;
  flow Real i;
algorithm
  v := 1;
end Pin;
model Test
  Pin p;
end Test;
