// error: extends.kind line 6 names P, Base
model Base
  constant Real x = 1;
end Base;
package P
  extends Base;
end P;
model Test
  Real y = P.x;
end Test;
