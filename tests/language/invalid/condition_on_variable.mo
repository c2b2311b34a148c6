// error: structural.not-constant line 6 names x
model A
end A;
model Test
  Real x = time;
  A a if x > 1;
end Test;
