// An outer component is the inner one of a component around it (5.4).
model World
  parameter Real g = 9.81;
  Real t = 2 * time;
end World;
model Body
  outer World world;
  Real a = world.g + world.t;
end Body;
model Test
  inner World world(g = 1);
  Body body[2];
end Test;
