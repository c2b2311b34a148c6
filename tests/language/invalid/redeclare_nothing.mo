// error: redeclare.nothing line 6 names x
model A
end A;
model Test
  extends A;
  redeclare Real x = 1;
end Test;
