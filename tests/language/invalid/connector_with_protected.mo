// error: class.protected line 6 names secret
connector Pin
  Real v;
  flow Real i;
protected
  Real secret;
end Pin;
model Test
  Pin p;
end Test;
