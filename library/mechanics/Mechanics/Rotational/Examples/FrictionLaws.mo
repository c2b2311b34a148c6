within Mechanics.Rotational.Examples;
model FrictionLaws "One inertia drives another through a clutch: slip, then stick, by a law of choice"
  parameter Types.StickLaw law = Types.StickLaw.rigid "How the plates stick" annotation(Evaluate = true);
  parameter Units.AngularVelocity w_0 = 100 "Initial speed of the fast shaft";
  Components.Inertia a(J = 0.2, w(start = w_0, fixed = true), phi(start = 0, fixed = true)) "Fast shaft";
  Components.Inertia b(J = 0.3, w(start = 0, fixed = true), phi(start = 0, fixed = true)) "Slow shaft";
  Components.FrictionClutch clutch(law = law, mu_0 = 0.12, K_1 = 0.12, K_3 = 0, N_f = 6, w_0 = 1e-4)
    "Clutch with constant friction coefficient";
  Signals.Sources.Constant force(k = 400) "Normal force";
  final parameter Units.Length leverArm = 0.95*6/3*(0.16^3 - 0.13^3)/(0.16^2 - 0.13^2) "Of its plates";
  final parameter Units.Time t_stick = w_0/(0.12*force.k*leverArm*(1/a.J + 1/b.J)) "End of the slip";
  output Units.AngularVelocity error "Difference of the mean speed and of the slip to the closed form";
equation
  connect(a.flange_b, clutch.flange_a);
  connect(clutch.flange_b, b.flange_a);
  connect(force.y, clutch.f_normal);
  // Closed form: momentum is kept, the slip falls linearly and stays zero
  error = abs(a.J*a.w + b.J*b.w - a.J*w_0)/a.J
    + noEvent(if time < t_stick then abs(clutch.w_rel + w_0*(1 - time/t_stick))
      elseif time > t_stick + 0.3 then abs(clutch.w_rel) else 0);
  annotation(
    experiment(StopTime = 2, Tolerance = 1e-6),
    Documentation(info = "<html>
<p>The slip falls with T (1/J_a + 1/J_b) until the plates stick; angular momentum is kept. All four laws agree but for
the instants after the end of the slip: elastic plates swing, those of Karnopp keep a slip of up to w_dead.</p>
</html>"));
end FrictionLaws;
