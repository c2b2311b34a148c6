// error: extends.cyclic line 2 names A
model A
  extends B;
end A;
model B
  extends A;
end B;
model Test
  extends A;
end Test;
