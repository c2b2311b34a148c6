within Mechanics.Rotational.Components;
model RigidPlanetary "Planetary gearset without elasticity or backlash, with the inertia of its planets"
  parameter Integer Z_s(min = 1) "Teeth of the sun";
  parameter Integer Z_p(min = 1) "Teeth of a planet";
  parameter Integer Z_r(min = 1) = Z_s + 2*Z_p "Teeth of the ring";
  parameter Integer N(min = 1) = 4 "Number of planets";
  parameter Units.Inertia J_self "Inertia of a planet about its own axis";
  parameter Units.Inertia J_orbit "Inertia of a planet about the main axis";
  Interfaces.Flange sun "Sun shaft";
  Interfaces.Flange carrier "Carrier shaft";
  Interfaces.Flange ring "Ring shaft";
  Units.Angle phi_planet(start = 0) "Absolute rotation of the planets";
  Units.AngularVelocity w_planet(start = 0) "Its rate";
  Units.AngularVelocity w_carrier(start = 0) "Speed of the carrier";
  Units.Torque tau_sun "Of the tooth forces at the sun, times Z_p/Z_s: on all planets";
  Units.Energy storedEnergy "Energy of the planets' motion";
  Units.Torque tau_ring "Of the tooth forces at the ring, times Z_p/Z_r: on all planets";
equation
  // Rolling without slip of the planets on sun and ring
  Z_s*sun.phi = (Z_s + Z_p)*carrier.phi - Z_p*phi_planet;
  Z_r*ring.phi = (Z_s + Z_p)*carrier.phi + Z_p*phi_planet;
  // Motion
  w_planet = der(phi_planet);
  w_carrier = der(carrier.phi);
  // Torques on the shafts
  Z_p*sun.tau = Z_s*tau_sun;
  Z_p*ring.tau = Z_r*tau_ring;
  // Newton's law for all planets, about their own axes and about the main axis
  N*J_self*der(w_planet) = tau_ring - tau_sun;
  N*J_orbit*der(w_carrier) = carrier.tau + (Z_s + Z_p)/Z_p*(tau_sun + tau_ring);
  // Energy
  storedEnergy = 0.5*N*(J_self*w_planet^2 + J_orbit*w_carrier^2);
  annotation(Documentation(info = "<html>
<p>Pitch radii stand as the numbers of teeth: Z_s phi_s = (Z_s + Z_p) phi_c - Z_p phi_p and Z_r phi_r = (Z_s + Z_p) phi_c
+ Z_p phi_p, which together are the equation of Willis. The planets turn with the constraint and orbit with the
carrier.</p>
</html>"));
end RigidPlanetary;
