within Mechanics.Rotational.Examples;
model FrictionBrakeHolds "A brake that sticks elastically holds a torque below its capacity"
  Sources.Torque drive(tau_start = 0, tau_end = 100, startTime = 0, duration = 0.2) "Drive";
  Components.Inertia rotor(J = 0.5, w(start = 0, fixed = true), phi(start = 0, fixed = true)) "Rotor";
  Components.FrictionBrake brake(law = Types.StickLaw.elastic) "Brake";
  Signals.Sources.Constant force(k = 3000) "Normal force";
  parameter Units.RotationalSpringConstant c = 5e4 "Stiffness of its plates: 25 kN.m/rad and millimetre, 2 mm";
  output Units.Ratio error "Difference to the wind-up at rest, relative";
equation
  connect(drive.flange, rotor.flange_a);
  connect(rotor.flange_b, brake.flange);
  connect(force.y, brake.f_normal);
  // Closed form: the plates are a spring
  error = c*rotor.phi/drive.tau_end - 1;
  annotation(
    experiment(StopTime = 1, Tolerance = 1e-8),
    Documentation(info = "<html>
<p>phi = tau/c once the plates have come to rest.</p>
</html>"));
end FrictionBrakeHolds;
