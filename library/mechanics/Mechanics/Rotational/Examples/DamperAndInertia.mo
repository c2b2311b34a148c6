within Mechanics.Rotational.Examples;
model DamperAndInertia "A damper stops an inertia"
  Components.Inertia inertia(
    J = 0.5,
    phi(start = 0, fixed = true),
    w(start = 20, fixed = true)) "Body";
  Components.Damper damper(d = 1.5) "Bearing";
  Components.Fixed case "Case";
  output Units.AngularVelocity error "Difference to the closed form";
equation
  connect(inertia.flange_b, damper.flange_a);
  connect(damper.flange_b, case.flange);
  // Closed form: w = w_0 exp(-d t / J)
  error = inertia.w - 20*exp(-3*time);
  annotation(
    experiment(StopTime = 1, Tolerance = 1e-8),
    Documentation(info = "<html>
<p>w = w_0 exp(-d t / J).</p>
</html>"));
end DamperAndInertia;
