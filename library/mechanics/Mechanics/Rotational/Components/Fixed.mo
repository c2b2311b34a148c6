within Mechanics.Rotational.Components;
model Fixed "Flange held by the case"
  extends Interfaces.PartialOneFlange;
  parameter Units.Angle phi_0 = 0 "Angle at which the flange is held";
equation
  // The case does not turn
  flange.phi = phi_0;
  annotation(Documentation(info = "<html>
<p>phi = phi_0; the case takes any torque.</p>
</html>"));
end Fixed;
