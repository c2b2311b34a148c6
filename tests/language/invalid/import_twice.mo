// error: import.duplicate line 10 names c
package A
  constant Real c = 1;
end A;
package B
  constant Real c = 2;
end B;
model Test
  import A.c;
  import B.c;
  Real x = c;
end Test;
