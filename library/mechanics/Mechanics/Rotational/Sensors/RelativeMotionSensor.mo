within Mechanics.Rotational.Sensors;
model RelativeMotionSensor "Angle and speed of one shaft relative to another"
  extends Interfaces.PartialTwoFlanges;
  output Units.Angle phi_rel "Angle of flange_b relative to flange_a";
  output Units.AngularVelocity w_rel "Speed of flange_b relative to flange_a";
equation
  // A sensor takes no torque
  flange_a.tau = 0;
  flange_b.tau = 0;
  // Measurement
  phi_rel = flange_b.phi - flange_a.phi;
  w_rel = der(phi_rel);
  annotation(Documentation(info = "<html>
<p>phi_b - phi_a and its derivative.</p>
</html>"));
end RelativeMotionSensor;
