// error: connect.conditional line 11 names p, q
connector Pin
  Real v;
  flow Real i;
end Pin;
model Test
  Pin p;
  Pin q;
equation
  if time > 1 then
    connect(p, q);
  end if;
end Test;
