// error: component.nested-prefix line 3 names p.u
connector Pair
  input Real u;
  Real v;
end Pair;
model Test
  output Pair p;
end Test;
