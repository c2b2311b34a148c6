// Redeclaration of a component in a modification and in extends; modifiers of the original stay (7.3.2).
model Base
  parameter Real k = 1;
  Real x;
end Base;
model Double
  extends Base;
  parameter Real extra = 0;
equation
  x = 2 * k + extra;
end Double;
model Triple
  extends Base;
equation
  x = 3 * k;
end Triple;
model System
  replaceable Triple part(k = 5) constrainedby Base(k = 4);
end System;
model Test
  System plain;
  System changed(redeclare Double part(extra = 1));
  System other(redeclare Double part, part.k = 6);
end Test;
