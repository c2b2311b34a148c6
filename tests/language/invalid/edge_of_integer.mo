// error: type.not-boolean line 3 names n
model Test
  Integer n = integer(time); Boolean b = edge(n);
end Test;
