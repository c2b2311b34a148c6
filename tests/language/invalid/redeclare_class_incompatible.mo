// error: redeclare.incompatible line 13 names Test.M, C.M
model A
  Real x = 1;
end A;
model B
  Integer x = 1;
end B;
model C
  replaceable model M = A;
  M m;
end C;
model Test
  C c(redeclare model M = B);
end Test;
