// What a constraining clause modifies stays with every later redeclaration; bases may repeat a declaration.
model A
  parameter Real p = 1;
end A;

model B
  parameter Real p = 1;
  parameter Real q = 1;
end B;

model Other
  parameter Real p = 5;
  parameter Real q = 6;
end Other;

model Base
  replaceable B b constrainedby A;
  replaceable model M = B constrainedby A;
  M m;
end Base;

model Middle
  extends Base(
    redeclare replaceable B b constrainedby B(p = 2, q = 3),
    redeclare replaceable model M = B constrainedby B(q = 4));
end Middle;

model One
  parameter Real start = 1;
  Real x(start = start, min = 0);
end One;

model Two
  parameter Real start = 1;
  Real x(min = 0);
end Two;

model Test
  extends Middle(redeclare Other b, redeclare model M = Other);
  extends One;
  extends Two(x(start = start));
equation
  der(x) = -x;
end Test;
