// error: lookup.unknown-literal line 4 names opn
type Mode = enumeration(open, closed);
model Test
  parameter Mode m = Mode.opn;
end Test;
