within Mechanics.Translational.Examples;
model DamperAndMass "A damper stops a mass"
  Components.Mass mass(
    m = 0.5,
    s(start = 0, fixed = true),
    v(start = 20, fixed = true)) "Body";
  Components.Damper damper(d = 1.5) "Damper";
  Components.Fixed wall "Case";
  output Units.Velocity error "Difference to the closed form";
equation
  connect(mass.flange_b, damper.flange_a);
  connect(damper.flange_b, wall.flange);
  // Closed form: v = v_0 exp(-d t / m)
  error = mass.v - 20*exp(-3*time);
  annotation(
    experiment(StopTime = 1, Tolerance = 1e-8),
    Documentation(info = "<html>
<p>v = v_0 exp(-d t / m).</p>
</html>"));
end DamperAndMass;
