// error: extends.combination line 4 names Signal, Real
connector Signal
  extends Real;
  Real more;
end Signal;
model Test
  Signal s;
end Test;
