// error: connector.unbalanced line 11 names plug says 2 flow variables and 3 potential
connector Pin
  Real v;
  flow Real i;
end Pin;
connector Plug
  Pin p[2];
  Real extra;
end Plug;
model Test
  Plug plug;
end Test;
