// error: class.component line 3 names a
record Pair
  input Real a;
  Real b = 1;
end Pair;
model Test
  Pair p(a = 1);
end Test;
