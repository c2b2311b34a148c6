// error: lookup.protected line 7 names P.c
package P
protected
  constant Real c = 1;
end P;
model Test
  import P.c;
  Real x = c;
end Test;
