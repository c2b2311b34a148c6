within Hydraulics.Valves;
model ThreeWayValve "Spool between supply, outlet and drain: positive motion fills the outlet, negative empties it"
  replaceable package Oil = Media.OilDexronVI constrainedby Media.PartialOil "Oil whose data are the default"
    annotation(choicesAllMatching = true);
  parameter Media.Fluid fluid = Oil.data "Oil";
  parameter Units.AbsolutePressure p_start = Constants.p_atmosphere "Proposed initial pressure of the outlet";
  // Spool
  parameter Mechanics.Units.Mass m "Mass of the spool and of what moves with it";
  parameter Mechanics.Units.TranslationalSpringConstant c "Stiffness of the spring";
  parameter Mechanics.Units.Force F_preload "Force of the spring at position 0, pushes towards negative position";
  parameter Mechanics.Units.TranslationalDampingConstant d "Damping";
  parameter Mechanics.Units.Position s_max "Position of the upper end stop; the lower one is at 0";
  parameter Mechanics.Units.TranslationalSpringConstant c_stop = 1e6 "Stiffness of the end stops; chosen: as Spool";
  parameter Mechanics.Units.ContactDampingConstant b_stop = 1 "Damping of the end stops; chosen: as Spool";
  // Edges
  parameter Mechanics.Units.Position s_supply "Position at which the edge to the supply opens";
  parameter Mechanics.Units.Position s_drain "Position at which the edge to the drain closes";
  parameter Units.Diameter d_edge "Diameter of the spool at its edges";
  parameter Units.Fraction coverage "Part of the circumference that is port";
  parameter Mechanics.Units.Length clearance = 10e-6 "Radial clearance; chosen: usual for transmission spools";
  parameter Boolean hasFlowForce = true "true: the jets pull their edges shut" annotation(Evaluate = true);
  parameter Units.Volume V_outlet "Volume of the outlet";
  // Connections
  Interfaces.Port supply "Supply";
  Interfaces.Port drain "Drain";
  Interfaces.Port outlet "Outlet";
  Mechanics.Translational.Interfaces.Flange flange "What else acts on the spool";
  Mechanics.Units.Mass m_oil "Mass of oil and air in the outlet";
  // Parts
  replaceable model SpoolModel = Components.Spool constrainedby Interfaces.PartialSpool "Law of motion"
    annotation(choicesAllMatching = true);
  SpoolModel spool(
    final m = m,
    final c = c,
    final F_preload = F_preload,
    final d = d,
    final s_max = s_max,
    final c_stop = c_stop,
    final b_stop = b_stop,
    final s_start = Functions.restPosition(F_preload, c, c_stop, 0, s_max)) "Spool with spring and end stops";
  Components.SpoolEdge supplyEdge(
    final fluid = fluid,
    final opens = Types.Direction.Positive,
    final overlap = s_supply,
    final d = d_edge,
    final coverage = coverage,
    final clearance = clearance,
    final hasFlowForce = hasFlowForce) "Supply to outlet";
  Components.SpoolEdge drainEdge(
    final fluid = fluid,
    final opens = Types.Direction.Negative,
    final overlap = -s_drain,
    final d = d_edge,
    final coverage = coverage,
    final clearance = clearance,
    final hasFlowForce = hasFlowForce) "Outlet to drain";
  Components.Volume volume(
    final fluid = fluid,
    final p_start = p_start,
    n = 3,
    final V_0 = V_outlet) "Outlet";
equation
  // Oil
  connect(supply, supplyEdge.port_a);
  connect(supplyEdge.port_b, volume.port[1]);
  connect(volume.port[2], drainEdge.port_a);
  connect(drainEdge.port_b, drain);
  connect(volume.port[3], outlet);
  m_oil = volume.m;
  // One rigid spool
  connect(spool.flange, supplyEdge.flange);
  connect(spool.flange, drainEdge.flange);
  connect(spool.flange, flange);
  annotation(Documentation(info = "<html>
<p>Between <code>s_drain</code> and <code>s_supply</code> the outlet is closed if s_drain &lt; s_supply, else connected to
both. States: what the spool model has, and the pressure of the outlet.</p>
</html>"));
end ThreeWayValve;
