within Mechanics.Rotational.Sensors;
model TorqueSensor "Torque between two shafts"
  extends Interfaces.PartialTwoFlanges;
  output Units.Torque tau "Torque that passes from flange_a to flange_b";
equation
  // A rigid, massless shaft
  flange_a.phi = flange_b.phi;
  flange_a.tau + flange_b.tau = 0;
  // Measurement
  tau = flange_a.tau;
  annotation(Documentation(info = "<html>
<p>tau = tau_a = -tau_b.</p>
</html>"));
end TorqueSensor;
