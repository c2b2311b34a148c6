// error: modification.unknown-attribute line 3 names b, unit
model Test
  Boolean b(unit = "m") = true;
end Test;
