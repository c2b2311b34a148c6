// error: redeclare.not-replaceable line 11 names M
model A
end A;
model B
end B;
model C
  model M = A;
  M m;
end C;
model Test
  C c(redeclare model M = B);
end Test;
