// error: call.arguments line 7 names b
record R
  Real a;
  Real b;
end R;
model Test
  R r = R(1);
end Test;
