// error: class.section line 5 names Pair
record Pair
  Real a;
  Real b;
equation
  a = b;
end Pair;
model Test
  Pair p;
equation
  p.a = 1;
end Test;
