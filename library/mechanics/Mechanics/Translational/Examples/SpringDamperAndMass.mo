within Mechanics.Translational.Examples;
model SpringDamperAndMass "Damped oscillator"
  Components.Fixed wall "Case";
  Components.SpringDamper strut(c = 50, d = 3) "Spring and damper";
  Components.Mass mass(
    m = 0.5,
    s(start = 0.1, fixed = true),
    v(start = 0, fixed = true)) "Body";
  output Units.Length error "Difference to the closed form";
protected
  constant Real w_d(unit = "rad/s") = sqrt(91) "Damped natural frequency";
equation
  connect(wall.flange, strut.flange_a);
  connect(strut.flange_b, mass.flange_a);
  // Closed form, decay rate d / (2 m) = 3 1/s and natural frequency sqrt(c / m) = 10 rad/s
  error = mass.s - 0.1*exp(-3*time)*(cos(w_d*time) + 3/w_d*sin(w_d*time));
  annotation(
    experiment(StopTime = 1, Tolerance = 1e-8),
    Documentation(info = "<html>
<p>s = s_0 exp(-delta t) (cos(w_d t) + delta / w_d sin(w_d t)) with delta = d / (2 m) and
w_d = sqrt(c / m - delta<sup>2</sup>).</p>
</html>"));
end SpringDamperAndMass;
