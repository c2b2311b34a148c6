// error: extends.replaceable line 6 names Test, Test.A
model Test
  replaceable model A
    Real x = 1;
  end A;
  extends A;
end Test;
