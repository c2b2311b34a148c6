// error: modification.final line 4 names a.unit
type Angle = Real(final unit = "rad");
model Test
  Angle a(unit = "deg") = 1;
end Test;
