within Mechanics.Rotational.Examples;
model GearedInertias "A torque drives two inertias coupled by a gear"
  Sources.Torque drive(tau_start = 3) "Drive";
  Components.Inertia fast(J = 0.1) "Driving body";
  Components.IdealGear gear(ratio = 2) "Reduction gear";
  Components.Inertia slow(J = 0.8) "Driven body";
  output Units.AngularAcceleration error "Difference to the closed form";
equation
  connect(drive.flange, fast.flange_a);
  connect(fast.flange_b, gear.flange_a);
  connect(gear.flange_b, slow.flange_a);
  // Closed form: tau = (J_1 + J_2 / ratio^2) a
  error = fast.a - 10;
  annotation(
    experiment(StopTime = 1, Tolerance = 1e-6),
    Documentation(info = "<html>
<p>a = tau / (J_1 + J_2 / ratio<sup>2</sup>). The gear removes one degree of freedom: two states remain.</p>
</html>"));
end GearedInertias;
