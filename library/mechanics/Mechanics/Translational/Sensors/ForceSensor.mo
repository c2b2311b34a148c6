within Mechanics.Translational.Sensors;
model ForceSensor "Force between two rods"
  extends Interfaces.PartialTwoFlanges;
  output Units.Force f "Force that passes from flange_a to flange_b";
equation
  // A rigid, massless rod
  flange_a.s = flange_b.s;
  flange_a.f + flange_b.f = 0;
  // Measurement
  f = flange_a.f;
  annotation(Documentation(info = "<html>
<p>f = f_a = -f_b.</p>
</html>"));
end ForceSensor;
