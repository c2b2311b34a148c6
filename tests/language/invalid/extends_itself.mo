// error: extends.cyclic line 2 names Test
model Test
  extends Test;
end Test;
