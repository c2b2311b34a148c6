// Several bases, one inherited twice (7.1.2), modified on the way; sections of all of them count.
model Root
  parameter Real k = 1;
  Real x(start = 0);
end Root;
model Left
  extends Root(k = 2);
  Real l = k * x;
end Left;
model Middle
  extends Left(k = 3, x(start = 5));
equation
  der(x) = -x;
end Middle;
model Other
  parameter Real unused = 7;
initial equation
  assert(unused > 0, "never");
end Other;
model Test
  extends Middle(k = 4);
  extends Other;
  Real y = 2 * l;
end Test;
