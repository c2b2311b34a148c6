// error: class.protected line 5 names hidden
record Pair
  Real a = 1;
protected
  Real hidden = 2;
end Pair;
model Test
  Pair p;
end Test;
