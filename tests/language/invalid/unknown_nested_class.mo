// error: lookup.unknown-class line 7 names P.Dampr
package P
  model Damper
  end Damper;
end P;
model Test
  P.Dampr d;
end Test;
