// error: redeclare.constant line 7 names c
model A
  replaceable constant Real c = 1;
end A;
model Test
  extends A;
  redeclare Real c = 2;
end Test;
