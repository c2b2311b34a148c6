// error: redeclare.missing line 8 names A
model Base
  model A
    Real x = 1;
  end A;
end Base;
model Test
  model A
    Real x = 2;
  end A;
  extends Base;
  A a;
end Test;
