// error: extends.kind line 6 names Test, Base
model Base
  Real x = 1;
end Base;
block Test
  extends Base;
end Test;
