within Mechanics.Rotational.Examples;
model TwoWayLock "A two-way clutch, locked both ways, lets go of a shaft that runs forwards"
  Sources.Torque drive(tau_start = 100) "Torque that drives the shaft forwards";
  Components.Inertia rotor(J = 0.5, w(start = 0, fixed = true), phi(start = 0, fixed = true)) "Shaft";
  Components.TwoWayClutch clutch(k = 0) "Clutch without stiffness";
  output Units.AngularVelocity error "Difference to the closed form";
equation
  connect(drive.flange, rotor.flange_a);
  connect(rotor.flange_b, clutch.flange);
  clutch.lockBothWays = time < 1;
  // Closed form: J dw/dt = T - b w, then J dw/dt = T
  error = rotor.w - noEvent(if time < 1 then 100/clutch.b*(1 - exp(-clutch.b*time/rotor.J)) else 100/clutch.b + 200*(time - 1));
  annotation(
    experiment(StopTime = 2, Tolerance = 1e-8),
    Documentation(info = "<html>
<p>Locked both ways: w = T/b (1 - exp(-b t/J)). From 1 s on the clutch is free forwards: w = T/b + T (t - 1 s)/J.</p>
</html>"));
end TwoWayLock;
