// error: type.pre line 5 names n says subscript
model Test
  Integer n = integer(time), table[3] = {1, 2, 3}, k;
equation
  k = pre(table[n]);
end Test;
