// error: lookup.unknown-name line 11 says extra
record Wide
  Real x;
  Real extra;
end Wide;
record Narrow
  Real x;
end Narrow;
model A
  outer Narrow r;
  Real y = r.extra;
end A;
model Test
  inner Wide r(x = 1, extra = 2);
  A a;
end Test;
