// error: lookup.unknown-class line 3 names Basis
model Test
  extends Basis;
end Test;
