// error: modification.unknown-attribute line 3 names x, strat
model Test
  Real x(strat = 1) = 2;
end Test;
