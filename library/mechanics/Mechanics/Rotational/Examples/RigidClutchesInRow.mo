within Mechanics.Rotational.Examples;
model RigidClutchesInRow "Three shafts locked to each other one after the other by rigid clutches"
  Components.Inertia a(J = 0.2, w(start = 60, fixed = true), phi(start = 0, fixed = true)) "First shaft";
  Components.Inertia b(J = 0.3, w(start = -20, fixed = true), phi(start = 0, fixed = true)) "Second shaft";
  Components.Inertia c(J = 0.5, w(start = 0, fixed = true), phi(start = 0, fixed = true)) "Third shaft";
  Components.RigidClutch left(mu_0 = 0.12, K_1 = 0.12, K_3 = 0) "Between first and second";
  Components.RigidClutch right(mu_0 = 0.12, K_1 = 0.12, K_3 = 0) "Between second and third";
  Sources.TorqueSignal drive "Drive of the first shaft";
  Signals.Sources.SmoothSteps force[2](each times = {0.2, 2}, values = {{0, 800, 800}, {0, 600, 0}}) "Normal forces";
  parameter Units.Torque tau_0 = 10 "Amplitude of the drive";
  parameter Real omega(unit = "rad/s") = 5 "Its angular frequency";
  parameter Units.AngularMomentum L_0 = 6 "Angular momentum at the start: 0.2*60 - 0.3*20";
  final parameter Units.AngularVelocity w_unit = 1 "Slip that counts as an error of 1";
  output Units.Ratio error "Difference to the conservation of momentum, and slip of stuck plates";
equation
  connect(drive.flange, a.flange_a);
  connect(a.flange_b, left.flange_a);
  connect(left.flange_b, b.flange_a);
  connect(b.flange_b, right.flange_a);
  connect(right.flange_b, c.flange_a);
  connect(force[1].y, left.f_normal);
  connect(force[2].y, right.f_normal);
  drive.tau = tau_0*cos(omega*time);
  // Momentum is that of the start and of the drive
  error = abs((a.J*a.w + b.J*b.w + c.J*c.w - tau_0/omega*sin(omega*time))/L_0 - 1)
    + (if left.stuck then abs(left.w_rel)/w_unit else 0) + (if right.stuck then abs(right.w_rel)/w_unit else 0);
  annotation(
    experiment(StopTime = 3, Tolerance = 1e-8),
    Documentation(info = "<html>
<p>Friction between the shafts changes nothing in their momentum, 6 N.m.s + &int; 10 cos(5 t) dt; plates that stick have
no slip. The right clutch opens again at 2 s.</p>
</html>"));
end RigidClutchesInRow;
