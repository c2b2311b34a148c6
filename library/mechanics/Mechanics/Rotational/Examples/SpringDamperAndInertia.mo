within Mechanics.Rotational.Examples;
model SpringDamperAndInertia "Damped torsional oscillator"
  Components.Fixed case "Case";
  Components.SpringDamper shaft(c = 50, d = 3) "Shaft";
  Components.Inertia inertia(
    J = 0.5,
    phi(start = 0.1, fixed = true),
    w(start = 0, fixed = true)) "Body";
  output Units.Angle error "Difference to the closed form";
protected
  constant Units.AngularVelocity w_d = sqrt(91) "Damped natural frequency";
equation
  connect(case.flange, shaft.flange_a);
  connect(shaft.flange_b, inertia.flange_a);
  // Closed form, decay rate d / (2 J) = 3 1/s and natural frequency sqrt(c / J) = 10 rad/s
  error = inertia.phi - 0.1*exp(-3*time)*(cos(w_d*time) + 3/w_d*sin(w_d*time));
  annotation(
    experiment(StopTime = 1, Tolerance = 1e-8),
    Documentation(info = "<html>
<p>phi = phi_0 exp(-delta t) (cos(w_d t) + delta / w_d sin(w_d t)) with delta = d / (2 J) and
w_d = sqrt(c / J - delta<sup>2</sup>).</p>
</html>"));
end SpringDamperAndInertia;
