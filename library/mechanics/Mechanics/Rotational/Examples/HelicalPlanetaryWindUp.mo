within Mechanics.Rotational.Examples;
model HelicalPlanetaryWindUp "Slow torque on the sun of a helical gearset with carrier and ring held"
  parameter Units.Torque tau = 100 "Final torque";
  Sources.Torque drive(tau_start = 0, tau_end = tau, startTime = 0.01, duration = 0.3) "Torque of the bench";
  Components.Inertia rotor(J = 0.005) "Sun shaft";
  Components.HelicalPlanetary gearset(
    Z_s = 37,
    Z_p = 33,
    m_n = 1.3e-3,
    beta = 0.35,
    b_w = 25e-3,
    c_sun = 3e8,
    d_mesh = 1000) "Gearset; tooth numbers of a passenger car's transmission, the rest chosen";
  Components.Fixed carrier "Held carrier";
  Components.Fixed ring "Held ring";
  Units.Force F "Force at each mesh in the static closed form";
  output Units.Angle error "Difference to the static closed form";
equation
  connect(drive.flange, rotor.flange_a);
  connect(rotor.flange_b, gearset.sun);
  connect(gearset.carrier, carrier.flange);
  connect(gearset.ring, ring.flange);
  // Closed form: two meshes, and the bearing with twice the force at half the motion
  F = drive.tau/gearset.N/gearset.R_s;
  error = rotor.phi - (
    2*F/gearset.c_sun/gearset.projection^2 + gearset.b_mesh
    + 4*F/gearset.c_bearing + gearset.b_bearing)/gearset.R_s;
  annotation(
    experiment(StopTime = 1, Tolerance = 1e-6),
    Documentation(info = "<html>
<p>At rest R_s phi_s = 2 F/c + b_mesh + 4 F/c_bearing + b_bearing with the force F = tau/(N R_s) at each mesh. The play
seen at the sun, from contact to contact, is 2 (b_mesh + b_bearing)/R_s. <code>error</code> vanishes once the ramp is
over.</p>
</html>"));
end HelicalPlanetaryWindUp;
