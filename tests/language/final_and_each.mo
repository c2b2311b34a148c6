// final values stay, each gives one value to every element (7.2.5, 7.2.6).
model A
  parameter Real p[2] = {1, 2};
  parameter Real q = 0;
  final parameter Real r = 2 * q;
  Real x(start = 0);
equation
  der(x) = sum(p) + r;
end A;
model Test
  A a[2](each p = {3, 4}, q = {5, 6}, each x(start = 7));
  A b(final q = 8);
end Test;
