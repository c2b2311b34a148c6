// A function of a component: modifications in its class know the component's parameters (5.3.2, 6.2.2).
package T
  function attraction
    input Real r;
    input Real g = 1;
    output Real a;
  algorithm
    a := g / r ^ 2;
  end attraction;
  partial model Field
    parameter Real g = 9.81;
    replaceable function field = attraction(g = 2 * g);
  end Field;
  model World
    extends Field(g = 3);
  end World;
  model Body
    outer World world;
    Real a = world.field(1 + time);
  end Body;
  model Test
    inner World world;
    World other(g = 5);
    Body body;
    Real b = other.field(2 * time);
  end Test;
end T;
