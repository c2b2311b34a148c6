within Mechanics.Translational.Examples;
model SpringAndMass "Undamped oscillator"
  Components.Fixed wall "Case";
  Components.Spring spring(c = 50) "Spring";
  Components.Mass mass(
    m = 0.5,
    s(start = 0.1, fixed = true),
    v(start = 0, fixed = true)) "Body";
  output Units.Length error "Difference to the closed form";
equation
  connect(wall.flange, spring.flange_a);
  connect(spring.flange_b, mass.flange_a);
  // Closed form: s = s_0 cos(sqrt(c / m) t)
  error = mass.s - 0.1*cos(10*time);
  annotation(
    experiment(StopTime = 1, Tolerance = 1e-8),
    Documentation(info = "<html>
<p>s = s_0 cos(sqrt(c / m) t).</p>
</html>"));
end SpringAndMass;
