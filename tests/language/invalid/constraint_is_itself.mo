// error: redeclare.cyclic line 6 names M
model A
  Real x = 1;
end A;
model Base
  replaceable model M = A constrainedby M;
  M m;
end Base;
model Test
  extends Base(redeclare model M = A);
end Test;
