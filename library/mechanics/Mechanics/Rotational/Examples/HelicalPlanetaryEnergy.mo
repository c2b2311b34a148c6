within Mechanics.Rotational.Examples;
model HelicalPlanetaryEnergy "Helical gearset with its ring held drives an inertia; no energy is lost unseen"
  Sources.Torque drive(tau_start = 0, tau_end = 50, duration = 0.05) "Drive";
  Components.Inertia input_(J = 0.02) "Sun shaft";
  Components.HelicalPlanetary gearset(
    Z_s = 43,
    Z_p = 19,
    m_n = 1.3e-3,
    beta = 0.35,
    b_w = 25e-3,
    c_sun = 3e8,
    d_mesh = 1000,
    b_mesh = 0,
    b_bearing = 0) "Gearset without play";
  Components.Inertia load(J = 0.5) "Carrier shaft";
  Components.Fixed ring "Held ring";
  Units.Energy supplied(start = 0, fixed = true) "Work of the drive";
  Units.Energy lost(start = 0, fixed = true) "Heat";
  Units.Energy kinetic "Energy of motion";
  Units.Energy elastic "Energy of the springs";
  output Real error(unit = "1") "What is missing in the energy balance, relative to the work";
  Units.Ratio ratio "Speed of the sun over that of the carrier";
equation
  connect(drive.flange, input_.flange_a);
  connect(input_.flange_b, gearset.sun);
  connect(gearset.carrier, load.flange_a);
  connect(gearset.ring, ring.flange);
  // Energy balance
  der(supplied) = drive.tau*input_.w;
  der(lost) = gearset.lossPower;
  kinetic = 0.5*(input_.J*input_.w^2 + load.J*load.w^2 + gearset.J_self*gearset.w_planet*gearset.w_planet
    + gearset.J_orbit*gearset.w_orbit*gearset.w_orbit);
  elastic = 0.5*gearset.projection^2*(gearset.c_sun*gearset.delta_sun*gearset.delta_sun
    + gearset.c_ring*gearset.delta_ring*gearset.delta_ring)
    + 0.5*gearset.c_bearing*gearset.delta_bearing*gearset.delta_bearing;
  error = (supplied - lost - kinetic - elastic)/(1 + supplied);
  ratio = noEvent(if abs(load.w) > 1 then input_.w/load.w else 0);
  annotation(
    experiment(StopTime = 0.5, Tolerance = 1e-6),
    Documentation(info = "<html>
<p>Work of the drive = heat + energy of motion + energy of the springs. The speeds settle at 1 + Z_r/Z_s.</p>
</html>"));
end HelicalPlanetaryEnergy;
