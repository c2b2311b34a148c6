// error: redeclare.visibility line 10 names M
model A
  replaceable model M
    Real x = 1;
  end M;
end A;
model Test
  extends A;
protected
  redeclare model M
    Real x = 2;
  end M;
  M m;
end Test;
