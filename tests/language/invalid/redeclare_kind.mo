// error: redeclare.kind line 9 names c.a
model A
  Real x = 1;
end A;
model C
  replaceable A a;
end C;
model Test
  C c(redeclare model a = A);
end Test;
