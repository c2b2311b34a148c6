// `redeclare` as an element of the class body, of a component and of a class.
model Base
  parameter Real k = 1;
  Real x;
end Base;
model Double
  extends Base;
equation
  x = 2 * k;
end Double;
model System
  replaceable model Part = Base;
  replaceable Base single(k = 3);
  Part first;
end System;
model Test
  extends System;
  redeclare model Part = Double(k = 7);
  redeclare Double single;
end Test;
