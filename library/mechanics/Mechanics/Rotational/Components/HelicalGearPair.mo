within Mechanics.Rotational.Components;
model HelicalGearPair "Pair of helical gears with elastic, damped mesh and backlash"
  extends Interfaces.PartialTwoFlanges;
  parameter Integer Z_a(min = 1) "Teeth of the gear on flange_a";
  parameter Integer Z_b(min = 1) "Teeth of the gear on flange_b";
  parameter Units.Length m_n "Normal module";
  parameter Units.Angle beta = 0 "Helix angle";
  parameter Units.Angle alpha_n = 0.3490658503988659 "Normal pressure angle; chosen: 20 degrees, the usual rack";
  parameter Units.TranslationalSpringConstant c "Mesh stiffness along the line of action";
  parameter Units.TranslationalDampingConstant d = 0 "Mesh damping along the line of action";
  parameter Units.Length b(min = 0) = 0 "Circumferential backlash at the pitch circles";
  final parameter Units.Length R_a = m_n/cos(beta)*Z_a/2 "Pitch radius of the gear on flange_a";
  final parameter Units.Length R_b = m_n/cos(beta)*Z_b/2 "Pitch radius of the gear on flange_b";
  final parameter Units.Ratio projection = cos(atan(tan(alpha_n)/cos(beta)))
    "Cosine of the transverse pressure angle: deflection along the line of action over that at the pitch circle";
  Units.Length delta(start = 0, nominal = 1e-5) "Deflection at the pitch circles";
  Units.Velocity delta_dot "Its rate";
  Units.Force F "Tangential force at the pitch circles";
  Units.Power lossPower "Power turned into heat";
  Units.Energy storedEnergy "Energy of the mesh";
equation
  // Deflection; flange_b counts positive in the direction in which flange_a drives it
  delta = R_a*flange_a.phi - R_b*flange_b.phi;
  delta_dot = der(delta);
  // Tooth contact
  F = projection*Functions.backlashForce(projection*delta, projection*delta_dot, projection*b, c, d);
  // Torques about the gears' own axes
  flange_a.tau = R_a*F;
  flange_b.tau = -R_b*F;
  // Energy
  lossPower = (F - projection*Functions.backlashForce(projection*delta, 0, projection*b, c, 0))*delta_dot;
  storedEnergy = Functions.backlashEnergy(projection*delta, projection*b, c);
  annotation(Documentation(info = "<html>
<p>delta = R_a phi_a - R_b phi_b with R = m_t Z / 2 and the transverse module m_t = m_n / cos(beta). Along the line of
action deflection and force are those at the pitch circle times and over cos(alpha_t), tan(alpha_t) = tan(alpha_n) /
cos(beta). There is no axial motion. The angle of flange_b counts positive in the direction in which flange_a turns it
(its axis is the reversed one of an external pair), so that ratio and torques are those of an ideal gear.</p>
<p>Source of the geometry: ISO 21771, Gears - Cylindrical involute gears and gear pairs; of the stiffness along the
line of action in the transverse plane: ISO 6336-1.</p>
</html>"));
end HelicalGearPair;
