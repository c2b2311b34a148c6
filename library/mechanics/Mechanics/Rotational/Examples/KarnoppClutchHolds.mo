within Mechanics.Rotational.Examples;
model KarnoppClutchHolds "A brake with a dead zone holds a growing torque up to its capacity, then slips"
  Sources.TorqueSignal drive "Drive";
  Components.Inertia rotor(J = 0.5, w(start = 0, fixed = true), phi(start = 0, fixed = true)) "Rotor";
  Components.KarnoppClutch brake(mu_0 = 0.1, K_1 = 0.1, K_3 = 0) "Brake with constant friction coefficient";
  Components.Fixed case "Case";
  Signals.Sources.Constant force(k = 1000) "Normal force";
  parameter Units.TorqueRate rate = 80 "Rise of the torque";
  final parameter Units.Torque T = 0.1*force.k*brake.leverArm "Capacity";
  final parameter Units.Time t_slip = T/rate "Instant at which the plates begin to slip";
  output Units.AngularVelocity error "Difference to the closed form";
equation
  connect(drive.flange, rotor.flange_a);
  connect(rotor.flange_b, brake.flange_b);
  connect(brake.flange_a, case.flange);
  connect(force.y, brake.f_normal);
  drive.tau = rate*time;
  // Closed form: at rest up to the capacity, then J w = rate (t - t_slip)^2/2
  error = rotor.w - noEvent(if time < t_slip then 0 else rate/rotor.J*(time - t_slip)^2/2);
  annotation(
    experiment(StopTime = 1, Tolerance = 1e-8),
    Documentation(info = "<html>
<p>Within the dead zone the plates take the torque of the drive. From the capacity T on they slip: w = rate (t -
T/rate)<sup>2</sup>/(2 J).</p>
</html>"));
end KarnoppClutchHolds;
