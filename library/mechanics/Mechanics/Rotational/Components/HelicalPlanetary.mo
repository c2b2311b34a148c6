within Mechanics.Rotational.Components;
model HelicalPlanetary "Planetary gearset with individual planets on elastic bearings and elastic helical meshes"
  parameter Integer Z_s(min = 1) "Teeth of the sun";
  parameter Integer Z_p(min = 1) "Teeth of a planet";
  parameter Integer Z_r(min = 1) = Z_s + 2*Z_p "Teeth of the ring";
  parameter Integer N(min = 1) = 4 "Number of planets" annotation(Evaluate = true);
  parameter Units.Length m_n "Normal module";
  parameter Units.Angle beta = 0 "Helix angle";
  parameter Units.Angle alpha_n = 0.3490658503988659 "Normal pressure angle; chosen: 20 degrees, the usual rack";
  parameter Units.Length b_w "Face width";
  parameter Units.Density rho = 7850 "Density of the planets; chosen: steel";
  parameter Real k_self(unit = "1") = 1 "Factor on the inertia of a planet about its own axis";
  parameter Real k_orbit(unit = "1") = 1 "Factor on the inertia of a planet about the main axis";
  parameter Units.TranslationalSpringConstant c_sun "Stiffness of a sun mesh along the line of action";
  parameter Units.TranslationalSpringConstant c_ring = c_sun "Stiffness of a ring mesh along the line of action";
  parameter Units.TranslationalDampingConstant d_mesh "Damping of a mesh along the line of action";
  parameter Units.Length b_mesh(min = 0) = 25e-6 "Circumferential backlash of a mesh";
  parameter Units.TranslationalSpringConstant c_bearing = 1e7 "Stiffness of a planet bearing";
  parameter Units.TranslationalDampingConstant d_bearing = 1000 "Damping of a planet bearing";
  parameter Units.Length b_bearing(min = 0) = 25e-6 "Total play of a planet bearing";
  final parameter Units.Length R_s = m_n/cos(beta)*Z_s/2 "Pitch radius of the sun";
  final parameter Units.Length R_p = m_n/cos(beta)*Z_p/2 "Pitch radius of a planet";
  final parameter Units.Length R_r = m_n/cos(beta)*Z_r/2 "Pitch radius of the ring";
  final parameter Units.Length R_c = R_s + R_p "Radius of the orbit of the planets";
  final parameter Units.Inertia J_self =
    k_self*0.5*rho*b_w*3.141592653589793*(Z_p*m_n/2)^4 "Inertia of a planet about its own axis";
  final parameter Units.Inertia J_orbit =
    k_orbit*rho*b_w*3.141592653589793*(Z_p*m_n/2)^2*(m_n*(Z_p + Z_s)/2)^2 "Inertia of a planet about the main axis";
  final parameter Units.Ratio projection = cos(atan(tan(alpha_n)/cos(beta)))
    "Cosine of the transverse pressure angle";
  Interfaces.Flange sun "Sun shaft";
  Interfaces.Flange carrier "Carrier shaft";
  Interfaces.Flange ring "Ring shaft";
  Units.Angle phi_planet[N](each start = 0, each stateSelect = StateSelect.prefer) "Absolute rotation of the planets";
  Units.AngularVelocity w_planet[N](each start = 0, each stateSelect = StateSelect.prefer) "Its rate";
  Units.Angle phi_orbit[N](each start = 0, each stateSelect = StateSelect.prefer) "Motion of the planets about the main axis";
  Units.AngularVelocity w_orbit[N](each start = 0, each stateSelect = StateSelect.prefer) "Its rate";
  Units.Length delta_sun[N](each nominal = 1e-5) "Deflections at the sun";
  Units.Length delta_ring[N](each nominal = 1e-5) "Deflections at the ring";
  Units.Length delta_bearing[N](each nominal = 1e-5) "Deflections of the bearings";
  Units.Velocity v_sun[N] "Rates of the deflections at the sun";
  Units.Velocity v_ring[N] "Rates of the deflections at the ring";
  Units.Velocity v_bearing[N] "Rates of the deflections of the bearings";
  Units.Force F_sun[N] "Tangential forces at the sun, positive when the sun drives";
  Units.Force F_ring[N] "Tangential forces at the ring, positive when the ring drives";
  Units.Force F_bearing[N] "Forces of the bearings, positive when the carrier drives";
  Units.Power lossPower "Power turned into heat";
  Units.Energy storedEnergy "Energy of the planets' motion, of the meshes and of the bearings";
protected
  Units.Force F_elastic[3, N] "The same forces without damping";
  Units.Energy E_elastic[N] "Energy of the springs at each planet";
equation
  for i in 1:N loop
    // Motion
    w_planet[i] = der(phi_planet[i]);
    w_orbit[i] = der(phi_orbit[i]);
    // Deflections at the pitch circles and in the bearing
    delta_sun[i] = R_s*sun.phi - R_c*phi_orbit[i] + R_p*phi_planet[i];
    delta_ring[i] = R_r*ring.phi - R_c*phi_orbit[i] - R_p*phi_planet[i];
    delta_bearing[i] = R_c*(carrier.phi - phi_orbit[i]);
    v_sun[i] = der(delta_sun[i]);
    v_ring[i] = der(delta_ring[i]);
    v_bearing[i] = der(delta_bearing[i]);
    // Tooth and bearing forces
    F_sun[i] = projection*Functions.backlashForce(
      projection*delta_sun[i], projection*v_sun[i], projection*b_mesh, c_sun, d_mesh);
    F_ring[i] = projection*Functions.backlashForce(
      projection*delta_ring[i], projection*v_ring[i], projection*b_mesh, c_ring, d_mesh);
    F_bearing[i] = Functions.backlashForce(delta_bearing[i], v_bearing[i], b_bearing, c_bearing, d_bearing);
    // Newton's law for each planet, about its own axis and about the main axis
    J_self*der(w_planet[i]) = R_p*(F_ring[i] - F_sun[i]);
    J_orbit*der(w_orbit[i]) = R_c*(F_sun[i] + F_ring[i] + F_bearing[i]);
    // Energy
    F_elastic[1, i] = projection*Functions.backlashForce(projection*delta_sun[i], 0, projection*b_mesh, c_sun, 0);
    F_elastic[2, i] = projection*Functions.backlashForce(projection*delta_ring[i], 0, projection*b_mesh, c_ring, 0);
    F_elastic[3, i] = Functions.backlashForce(delta_bearing[i], 0, b_bearing, c_bearing, 0);
    E_elastic[i] = Functions.backlashEnergy(projection*delta_sun[i], projection*b_mesh, c_sun)
      + Functions.backlashEnergy(projection*delta_ring[i], projection*b_mesh, c_ring)
      + Functions.backlashEnergy(delta_bearing[i], b_bearing, c_bearing);
  end for;
  // Torques on the shafts
  sun.tau = R_s*sum(F_sun);
  ring.tau = R_r*sum(F_ring);
  carrier.tau = R_c*sum(F_bearing);
  // Energy
  lossPower = (F_sun - F_elastic[1, :])*v_sun + (F_ring - F_elastic[2, :])*v_ring
    + (F_bearing - F_elastic[3, :])*v_bearing;
  storedEnergy = 0.5*(J_self*w_planet*w_planet + J_orbit*w_orbit*w_orbit) + sum(E_elastic);
  annotation(Documentation(info = "<html>
<p>Each planet turns about its own axis (J_self) and moves about the main axis (J_orbit); its meshes with sun and ring
and its bearing are springs with damping and play:</p>
<ul>
<li>sun: R_s phi_s - R_c phi_orbit + R_p phi_planet,</li>
<li>ring: R_r phi_r - R_c phi_orbit - R_p phi_planet,</li>
<li>bearing: R_c (phi_c - phi_orbit).</li>
</ul>
<p>Where all deflections vanish these are the equations of rolling without slip, hence of the ideal gearset. Four
states per planet. J_self = 1/2 rho b_w pi (Z_p m_n/2)<sup>4</sup>, J_orbit = rho b_w pi (Z_p m_n/2)<sup>2</sup>
R<sup>2</sup> with R = m_n (Z_p + Z_s)/2: solid disks of the normal module's size. There is no axial motion.</p>
</html>"));
end HelicalPlanetary;
