// error: instance.recursive line 3 names A
model A
  A a;
end A;
model Test
  A a;
end Test;
