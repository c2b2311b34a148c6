// error: redeclare.nothing line 9 names N
model A
  replaceable model M
    Real x = 1;
  end M;
end A;
model Test
  extends A;
  redeclare model extends N
    Real y = 2;
  end N;
  N m;
end Test;
