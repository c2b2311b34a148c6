within Mechanics.Rotational.Examples;
model ElasticPlanetaryWindUp "Slow torque on the sun of an elastic gearset with carrier and ring held"
  Sources.Torque drive(tau_start = 0, tau_end = 100, startTime = 0.01, duration = 0.3) "Torque of the bench";
  Components.Inertia rotor(J = 0.005) "Sun shaft";
  Components.ElasticPlanetary gearset(ratio = 3, c = 8e3, d = 2, b = 3e-3) "Gearset";
  Components.Fixed carrier "Held carrier";
  Components.Fixed ring "Held ring";
  output Units.Angle error "Difference to the static closed form";
equation
  connect(drive.flange, rotor.flange_a);
  connect(rotor.flange_b, gearset.sun);
  connect(gearset.carrier, carrier.flange);
  connect(gearset.ring, ring.flange);
  // Closed form: half the play and the deflection
  error = rotor.phi - (gearset.b/2 + drive.tau/gearset.c);
  annotation(
    experiment(StopTime = 1, Tolerance = 1e-6),
    Documentation(info = "<html>
<p>At rest phi_s = b/2 + tau/c. <code>error</code> vanishes once the ramp is over.</p>
</html>"));
end ElasticPlanetaryWindUp;
