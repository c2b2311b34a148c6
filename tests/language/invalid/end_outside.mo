// error: syntax.expression line 3
model Test
  Real y = end;
end Test;
