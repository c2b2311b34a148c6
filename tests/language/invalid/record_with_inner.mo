// error: class.component line 3 names a
record Pair
  inner Real a = 1;
end Pair;
model Test
  Pair p;
end Test;
