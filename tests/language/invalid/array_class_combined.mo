// error: extends.combination line 9 names Test.Both, Test.Three
model Test
  model One
    Real x = 1;
  end One;
  model Three = One[3];
  model Both
    extends Three;
    Real y = 2;
  end Both;
  Both b;
end Test;
