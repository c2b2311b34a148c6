// error: instance.recursive line 6 names A
model A
  B b[3];
end A;
model B
  A a[3];
end B;
model Test
  A a;
end Test;
