// error: type.partial line 5 names a
partial model A
end A;
model Test
  A a;
end Test;
