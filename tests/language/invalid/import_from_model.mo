// error: import.not-package line 6 names A.c
model A
  constant Real c = 1;
end A;
model Test
  import A.c;
  Real x = c;
end Test;
