// error: redeclare.constant line 6 names c
model A
  replaceable constant Real c = 1;
end A;
model Test
  A a(redeclare Real c = 2);
end Test;
