within Mechanics.Rotational.Sensors;
model PowerSensor "Power that passes between two shafts"
  extends Interfaces.PartialTwoFlanges;
  output Units.Torque tau "Torque that passes from flange_a to flange_b";
  output Units.Power P "Power that passes from flange_a to flange_b";
equation
  // A rigid, massless shaft
  flange_a.phi = flange_b.phi;
  flange_a.tau + flange_b.tau = 0;
  // Measurement
  tau = flange_a.tau;
  P = tau*der(flange_a.phi);
  annotation(Documentation(info = "<html>
<p>P = tau w.</p>
</html>"));
end PowerSensor;
