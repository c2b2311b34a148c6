// error: redeclare.not-replaceable line 11 names c.a
model A
end A;
model B
  extends A;
end B;
model C
  A a;
end C;
model Test
  C c(redeclare B a);
end Test;
