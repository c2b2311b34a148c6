within TenSpeed.Gearbox;
record GearsetData "Geometry, elasticity and play of a planetary gearset"
  parameter Integer Z_s "Teeth of the sun";
  parameter Integer Z_p "Teeth of a planet";
  parameter Integer Z_r "Teeth of the ring";
  parameter Integer N = 4 "Number of planets";
  parameter Mechanics.Units.Length m_n = 1.3e-3 "Normal module; chosen: ring of 130 teeth with 180 mm diameter";
  parameter Mechanics.Units.Angle beta = 0.35 "Helix angle; chosen: 20 degrees, quiet gears";
  parameter Mechanics.Units.Length b_w = 25e-3 "Face width; chosen: usual for passenger cars";
  parameter Mechanics.Units.Density rho = 7850 "Density of the planets; chosen: steel";
  parameter Real k_self(unit = "1") = 1 "Factor on the inertia of a planet about its own axis; study: 0.75 to 1.25";
  parameter Real k_orbit(unit = "1") = 1 "Factor on the inertia of a planet about the main axis; study: 0.75 to 1.25";
  parameter Mechanics.Units.TranslationalSpringConstant c_mesh = 4e8
    "Stiffness of a mesh; chosen: 16 N/(mm um) of face width, a helical steel pair after ISO 6336-1";
  parameter Mechanics.Units.TranslationalDampingConstant d_mesh = 1000 "Damping of a mesh; chosen: as the bearing";
  parameter Mechanics.Units.Length b_mesh = 25e-6 "Tooth backlash; nominal value of the study (0 to 0.05 mm)";
  parameter Mechanics.Units.TranslationalSpringConstant c_bearing = 1e7
    "Stiffness of a planet bearing; nominal value of the study (7.5 to 12.5 kN/mm)";
  parameter Mechanics.Units.TranslationalDampingConstant d_bearing = 1000
    "Damping of a planet bearing; nominal value of the study (800 to 1200 N s/m)";
  parameter Mechanics.Units.Length b_bearing = 25e-6 "Bearing lash; nominal value of the study (0 to 0.05 mm)";
  parameter Mechanics.Units.RotationalSpringConstant c_lumped
    "Stiffness seen at the sun; measured by Benches.GearsetTorque";
  parameter Mechanics.Units.RotationalDampingConstant d_lumped "Damping seen at the sun; from the same deflections";
  parameter Mechanics.Units.Angle b_lumped "Play seen at the sun; measured by Benches.GearsetTorque";
  final parameter Mechanics.Units.Inertia J_self =
    k_self*0.5*rho*b_w*Mechanics.Constants.pi*(Z_p*m_n/2)^4 "Inertia of a planet about its own axis";
  final parameter Mechanics.Units.Inertia J_orbit =
    k_orbit*rho*b_w*Mechanics.Constants.pi*(Z_p*m_n/2)^2*(m_n*(Z_p + Z_s)/2)^2
    "Inertia of a planet about the main axis";
  annotation(Documentation(info = "<html>
<p>Planets are solid disks. The lumped values stand for a gearset whose elasticity is placed at its sun.</p>
</html>"));
end GearsetData;
