// error: extends.kind line 6 names Test.R, Test.M
model Test
  model M
    Real x = 1;
  end M;
  record R = M;
  R r;
end Test;
