within Hydraulics.Components;
model CylinderPiston "Piston with mass, viscous friction and elastic end stops"
  parameter Mechanics.Units.Mass m "Mass of the piston and its rod";
  parameter Mechanics.Units.TranslationalDampingConstant d(min = 0) = 0 "Viscous friction";
  parameter Mechanics.Units.Length s_max "Stroke";
  parameter Mechanics.Units.TranslationalSpringConstant c_stop = 1e8 "Stiffness of the end stops; chosen: steel";
  parameter Mechanics.Units.ContactDampingConstant b_stop = 1 "Damping of the end stops; chosen: as Spool";
  Mechanics.Translational.Interfaces.Flange flange "Everything that acts on the piston";
  Mechanics.Units.Position s(start = 0, nominal = 0.1) "Position";
  Mechanics.Units.Velocity v(start = 0, nominal = 0.1) "Speed";
  Mechanics.Units.Force stopForce "Force of both end stops";
equation
  // Motion
  s = flange.s;
  v = der(s);
  // Elastic end stops, continuous in force
  stopForce = Mechanics.Functions.contactForce(-s, -v, c_stop, b_stop)
    - Mechanics.Functions.contactForce(s - s_max, v, c_stop, b_stop);
  // Newton's law
  m*der(v) = flange.f - d*v + stopForce;
  annotation(Documentation(info = "<html>
<p>m dv/dt = f - d v + stopForce, end stops by <code>Mechanics.Functions.contactForce</code>.</p>
</html>"));
end CylinderPiston;
