within Mechanics.Rotational.Examples;
model SpringAndInertia "Undamped torsional oscillator"
  Components.Fixed case "Case";
  Components.Spring spring(c = 50) "Shaft";
  Components.Inertia inertia(
    J = 0.5,
    phi(start = 0.1, fixed = true),
    w(start = 0, fixed = true)) "Body";
  output Units.Angle error "Difference to the closed form";
equation
  connect(case.flange, spring.flange_a);
  connect(spring.flange_b, inertia.flange_a);
  // Closed form: phi = phi_0 cos(sqrt(c / J) t)
  error = inertia.phi - 0.1*cos(10*time);
  annotation(
    experiment(StopTime = 1, Tolerance = 1e-8),
    Documentation(info = "<html>
<p>phi = phi_0 cos(sqrt(c / J) t).</p>
</html>"));
end SpringAndInertia;
