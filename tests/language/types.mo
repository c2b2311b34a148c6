// Types built on types; those of arrays; attributes for each element and for the whole.
model Test
  type Angle = Real(unit = "rad", displayUnit = "deg");
  type Position = Real[3](each unit = "m", start = {1, 2, 3});
  type Frame = Position[2];
  Angle a(quantity = "Angle") = 1;
  Position p = {1, 0, 0};
  Frame f;
  Angle angles[2](each nominal = 5, start = {0.1, 0.2});
equation
  f = {{1, 2, 3}, p};
  angles = {1, 2};
end Test;
