within Mechanics.Rotational.Examples;
model OverrunningClutch "A shaft runs ahead, is braked, and is held by its one-way clutch"
  Sources.Torque drive(tau_start = -20) "Torque that brakes the shaft";
  Components.Inertia rotor(J = 0.5, w(start = 40, fixed = true), phi(start = 0, fixed = true)) "Shaft";
  Components.OneWayClutch clutch(k = 0) "Clutch without stiffness";
  Components.Fixed case "Case";
  final parameter Units.Time t_lock = rotor.J*(40 - clutch.w_lock)/20 "Instant at which it locks";
  output Units.AngularVelocity error "Difference to the closed form";
equation
  connect(drive.flange, rotor.flange_a);
  connect(rotor.flange_b, clutch.flange_b);
  connect(clutch.flange_a, case.flange);
  // Closed form: free until it locks; then, once at rest, dw/dt = (-20 - b w)/J
  error = rotor.w - noEvent(if time < t_lock then 40 - 40*time elseif time > t_lock + 0.01 then -20/clutch.b else rotor.w);
  annotation(
    experiment(StopTime = 1.5, Tolerance = 1e-8),
    Documentation(info = "<html>
<p>Free: w = 40 rad/s - 40 rad/s<sup>2</sup> t. Locked, the shaft creeps back with T/b.</p>
</html>"));
end OverrunningClutch;
