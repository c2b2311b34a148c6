// error: modification.final line 12 names B
model A
  final replaceable model B
    Real x = 1;
  end B;
  B b;
end A;
model C
  Real x = 2;
end C;
model Test
  A a(redeclare model B = C);
end Test;
