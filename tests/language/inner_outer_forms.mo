package Forms "inner outer, nested inner, and inner components that nobody declares (5.4)"
  model World
    parameter Real g = 9.81;
    annotation (missingInnerMessage = "A world with the default gravity is added.");
  end World;

  model Body
    outer World world;
    Real f = 2 * world.g;
  end Body;

  model Switch
    outer Boolean on;
    Real y = if on then 1 else 0;
  end Switch;

  model Group "Hands its own switch down: both its own and that around must be on"
    parameter Boolean enable = true;
    inner outer Boolean on = on and enable;
    Switch part;
    Boolean around = on;
  end Group;

  model Test
    inner Boolean on = time > 1;
    Body body;
    Group group(enable = false);
    Group other;
  end Test;
end Forms;
