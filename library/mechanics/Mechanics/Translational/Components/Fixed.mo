within Mechanics.Translational.Components;
model Fixed "Flange held by the case"
  extends Interfaces.PartialOneFlange;
  parameter Units.Position s_0 = 0 "Position at which the flange is held";
equation
  // The case does not move
  flange.s = s_0;
  annotation(Documentation(info = "<html>
<p>s = s_0; the case takes any force.</p>
</html>"));
end Fixed;
