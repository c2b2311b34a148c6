within Mechanics.Rotational.Examples;
model RigidPlanetaryDrive "Sun drives the carrier of a gearset with heavy planets and held ring"
  Sources.Torque drive(tau_start = 30) "Drive";
  Components.RigidPlanetary gearset(Z_s = 40, Z_p = 20, J_self = 1e-3, J_orbit = 5e-3) "Gearset";
  Components.Inertia input_(J = 0.01) "Sun shaft";
  Components.Inertia load(J = 0.2) "Carrier shaft";
  Components.Fixed ring "Held ring";
  final parameter Units.Inertia J = 0.01 + (0.2 + 4*5e-3 + 4*1e-3*3^2)/9 "Of everything, seen at the sun";
  output Units.AngularAcceleration error "Difference to the closed form";
equation
  connect(drive.flange, input_.flange_a);
  connect(input_.flange_b, gearset.sun);
  connect(gearset.carrier, load.flange_a);
  connect(gearset.ring, ring.flange);
  // Closed form: w_sun = 3 w_carrier, w_planet = -3 w_carrier
  error = input_.a - 30/J;
  annotation(
    experiment(StopTime = 1, Tolerance = 1e-6),
    Documentation(info = "<html>
<p>With 40, 20 and 80 teeth and a held ring w_sun = 3 w_carrier and a planet turns with w_planet = -3 w_carrier: the inertia at
the sun is J_s + (J_c + N J_orbit + N J_self 3<sup>2</sup>)/3<sup>2</sup>.</p>
</html>"));
end RigidPlanetaryDrive;
