within Mechanics.Rotational.Examples;
model GearPairWindUp "Slow torque on a helical gear pair whose other gear is held"
  Sources.Torque drive(tau_start = 0, tau_end = 200, startTime = 0.01, duration = 0.3) "Torque of the bench";
  Components.Inertia rotor(J = 0.01) "Driving shaft";
  Components.HelicalGearPair pair(Z_a = 40, Z_b = 80, m_n = 2e-3, beta = 0.4, c = 4e8, d = 2000, b = 50e-6)
    "Gears; chosen: a transfer gear of a passenger car";
  Components.Fixed held "Held shaft";
  output Units.Angle error "Difference to the static closed form";
equation
  connect(drive.flange, rotor.flange_a);
  connect(rotor.flange_b, pair.flange_a);
  connect(pair.flange_b, held.flange);
  // Closed form: half the backlash and the deflection of the mesh
  error = rotor.phi - (drive.tau/pair.R_a/pair.c/pair.projection^2 + pair.b/2)/pair.R_a;
  annotation(
    experiment(StopTime = 1, Tolerance = 1e-6),
    Documentation(info = "<html>
<p>At rest R_a phi_a = tau/(R_a c cos(alpha_t)<sup>2</sup>) + b/2. <code>error</code> vanishes once the ramp is over.</p>
</html>"));
end GearPairWindUp;
