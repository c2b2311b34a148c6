// error: unsupported.class-extends line 9 names M
model A
  replaceable model M
    Real x = 1;
  end M;
end A;
model Test
  extends A;
  redeclare model extends M
    Real y = 2;
  end M;
  M m;
end Test;
