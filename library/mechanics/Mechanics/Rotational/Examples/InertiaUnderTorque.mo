within Mechanics.Rotational.Examples;
model InertiaUnderTorque "A constant torque accelerates an inertia"
  Sources.Torque drive(tau_start = 2) "Drive";
  Components.Inertia inertia(
    J = 0.5,
    phi(start = 0, fixed = true),
    w(start = w_0, fixed = true)) "Body";
  parameter Units.AngularVelocity w_0 = 1 "Speed at time 0";
  output Units.Angle error "Difference to the closed form";
equation
  connect(drive.flange, inertia.flange_a);
  // Closed form: phi = w_0 t + tau t^2 / (2 J)
  error = inertia.phi - (w_0*time + drive.tau_start*time^2/(2*inertia.J));
  annotation(
    experiment(StopTime = 1, Tolerance = 1e-6),
    Documentation(info = "<html>
<p>phi = w_0 t + tau t<sup>2</sup> / (2 J).</p>
</html>"));
end InertiaUnderTorque;
