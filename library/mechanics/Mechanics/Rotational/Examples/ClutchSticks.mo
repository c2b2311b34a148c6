within Mechanics.Rotational.Examples;
model ClutchSticks "Two inertias at different speeds are coupled by a clutch: slip, then stick"
  Components.Inertia a(J = 0.2, w(start = w_0, fixed = true), phi(start = 0, fixed = true)) "Fast shaft";
  Components.Inertia b(J = 0.3, w(start = 0, fixed = true), phi(start = 0, fixed = true)) "Slow shaft";
  Components.ElasticClutch clutch(mu_0 = 0.12, K_1 = 0.12, K_3 = 0) "Clutch with constant friction coefficient";
  Signals.Sources.Constant force(k = 400) "Normal force";
  parameter Units.AngularVelocity w_0 = 100 "Initial speed of the fast shaft";
  final parameter Units.Time t_stick = w_0/(clutch.mu_0*force.k*clutch.leverArm*(1/a.J + 1/b.J)) "End of the slip";
  output Units.AngularVelocity error "Difference of the mean speed of both to the closed form, and of the slip until stick";
equation
  connect(a.flange_b, clutch.flange_a);
  connect(clutch.flange_b, b.flange_a);
  connect(force.y, clutch.f_normal);
  // Closed form: momentum is kept, the slip falls linearly
  error = (a.J*a.w + b.J*b.w)/a.J - w_0
    + noEvent(if time < t_stick then clutch.w_rel + w_0*(1 - time/t_stick) else 0);
  annotation(
    experiment(StopTime = 2, Tolerance = 1e-6),
    Documentation(info = "<html>
<p>The slip falls with T (1/J_a + 1/J_b) until the plates stick; angular momentum is kept.</p>
</html>"));
end ClutchSticks;
