// error: lookup.not-constant line 5 names x
model Test
  Real x = 1;
  model Inside
    Real y = x;
  end Inside;
  Inside i;
end Test;
