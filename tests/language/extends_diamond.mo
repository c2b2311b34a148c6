// The same element reached on two ways is one element.
model Base
  Real x;
end Base;
model A
  extends Base;
end A;
model B
  extends Base;
equation
  x = 1;
end B;
model Test
  extends A;
  extends B;
end Test;
