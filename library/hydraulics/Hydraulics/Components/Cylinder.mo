within Hydraulics.Components;
model Cylinder "Double-acting cylinder: two chambers, piston with mass, friction and elastic end stops"
  replaceable package Oil = Media.OilDexronVI constrainedby Media.PartialOil "Oil whose data are the default"
    annotation(choicesAllMatching = true);
  parameter Media.Fluid fluid = Oil.data "Oil";
  parameter Units.Area A_a "Area of the piston on side a";
  parameter Units.Area A_b "Area of the piston on side b, less that of the rod";
  parameter Mechanics.Units.Length s_max "Stroke";
  parameter Units.Volume V_dead(min = 1e-12) "Oil in each chamber at its end stop";
  parameter Mechanics.Units.Mass m "Mass of the piston and its rod";
  parameter Mechanics.Units.TranslationalDampingConstant d(min = 0) = 0 "Viscous friction";
  parameter Mechanics.Units.TranslationalSpringConstant c_stop = 1e8 "Stiffness of the end stops; chosen: steel";
  parameter Mechanics.Units.ContactDampingConstant b_stop = 1 "Damping of the end stops; chosen: as Spool";
  parameter Units.AbsolutePressure p_start = Constants.p_atmosphere "Proposed initial pressure in both chambers";
  Interfaces.Port port_a "Oil that pushes the rod out";
  Interfaces.Port port_b "Oil that pushes the rod in";
  Mechanics.Translational.Interfaces.Flange rod "Rod, position 0 is all the way in";
  CylinderPiston piston(
    final m = m,
    final d = d,
    final s_max = s_max,
    final c_stop = c_stop,
    final b_stop = b_stop) "Piston";
  SpoolChamber chamber_a(
    final fluid = fluid,
    final p_start = p_start,
    final pushes = Types.Direction.Positive,
    final A = A_a,
    final V_0 = V_dead) "Chamber on side a";
  SpoolChamber chamber_b(
    final fluid = fluid,
    final p_start = p_start,
    final pushes = Types.Direction.Negative,
    final A = A_b,
    final V_0 = V_dead + A_b*s_max) "Chamber on side b";
equation
  connect(port_a, chamber_a.port);
  connect(port_b, chamber_b.port);
  // One rigid piston
  connect(chamber_a.flange, piston.flange);
  connect(chamber_b.flange, piston.flange);
  connect(piston.flange, rod);
  annotation(Documentation(info = "<html>
<p>m dv/dt = A_a p_a - A_b p_b - (A_a - A_b) p_0 + f - d v + stopForce. Four states: both pressures, position and speed.
A cylinder with a single chamber is a <code>SpoolChamber</code> with a mass.</p>
</html>"));
end Cylinder;
