within Mechanics.Rotational.Examples;
model SmoothClutchCreeps "A brake with a smooth law creeps under load"
  Sources.Torque drive(tau_start = 10) "Drive";
  Components.Inertia rotor(J = 0.05, w(start = 0, fixed = true), phi(start = 0, fixed = true)) "Rotor";
  Components.SmoothClutch brake(mu_0 = 0.1, K_1 = 0.1, K_3 = 0) "Brake with constant friction coefficient";
  Components.Fixed case "Case";
  Signals.Sources.Constant force(k = 500) "Normal force";
  output Units.Ratio error "Difference to the creep at rest";
equation
  connect(drive.flange, rotor.flange_a);
  connect(rotor.flange_b, brake.flange_b);
  connect(brake.flange_a, case.flange);
  connect(force.y, brake.f_normal);
  // Closed form: tau = T tanh(w/w_0)
  error = tanh(rotor.w/brake.w_0) - drive.tau/brake.capacity;
  annotation(
    experiment(StopTime = 1, Tolerance = 1e-8),
    Documentation(info = "<html>
<p>w = w_0 atanh(tau/T) once the transient is over.</p>
</html>"));
end SmoothClutchCreeps;
