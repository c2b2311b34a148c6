// error: type.mismatch line 12 names r, s
record R
  Real a;
end R;
record S
  Real b;
end S;
model Test
  R r;
  S s;
equation
  r = s;
  s.b = 1;
end Test;
