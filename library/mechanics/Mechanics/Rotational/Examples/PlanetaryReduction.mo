within Mechanics.Rotational.Examples;
model PlanetaryReduction "Planetary gearset with its ring held"
  Sources.Torque drive(tau_start = 7) "Drive";
  Components.Inertia sun(J = 0.1) "Sun shaft";
  Components.IdealPlanetary gearset(ratio = 3) "Gearset";
  Components.Inertia carrier(J = 4) "Carrier shaft";
  Components.IdealBrake brake(engaged = true) "Ring brake";
  output Units.AngularAcceleration error "Difference to the closed form";
equation
  connect(drive.flange, sun.flange_a);
  connect(sun.flange_b, gearset.sun);
  connect(gearset.carrier, carrier.flange_a);
  connect(gearset.ring, brake.flange);
  // Closed form: tau = (J_sun + J_carrier / (1 + i)^2) a
  error = sun.a - 20;
  annotation(
    experiment(StopTime = 1, Tolerance = 1e-6),
    Documentation(info = "<html>
<p>With the ring held, w_sun = (1 + i) w_carrier and a = tau / (J_sun + J_carrier / (1 + i)<sup>2</sup>).</p>
</html>"));
end PlanetaryReduction;
