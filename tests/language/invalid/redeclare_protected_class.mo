// error: lookup.protected line 13 names M
model A
  M m;
protected
  replaceable model M
    Real x = 1;
  end M;
end A;
model N
  Real x = 2;
end N;
model Test
  A a(redeclare model M = N);
end Test;
