// An outer modification wins over an inner one, attribute by attribute (7.2.4).
model Leaf
  parameter Real p(min = 0, max = 1) = 0.1;
  Real x(start = 1, nominal = 2);
equation
  der(x) = p;
end Leaf;
model Branch
  Leaf leaf(p(max = 2) = 0.2, x(start = 3));
  parameter Real q = 6;
end Branch;
model Test
  parameter Real own = 9;
  Branch branch(leaf(p = 0.3, x.start = own), q = 2 * own);
end Test;
