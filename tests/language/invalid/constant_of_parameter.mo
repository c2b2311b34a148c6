// error: flat.variability line 4 names c, p
model Test
  parameter Real p = 1;
  constant Real c = p;
end Test;
