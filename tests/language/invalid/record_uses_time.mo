// error: class.time line 3 names R, time
record R
  Real x = time;
end R;
model Test
  R r;
end Test;
