// error: class.section line 4 names P
package P
  constant Real c = 1;
equation
  c = 1;
end P;
model Test
  Real x = P.c;
end Test;
