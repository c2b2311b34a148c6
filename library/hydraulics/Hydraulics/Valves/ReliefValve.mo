within Hydraulics.Valves;
model ReliefValve "Spool that opens an edge from its inlet volume to the drain"
  replaceable package Oil = Media.OilDexronVI constrainedby Media.PartialOil "Oil whose data are the default"
    annotation(choicesAllMatching = true);
  parameter Media.Fluid fluid = Oil.data "Oil";
  parameter Units.AbsolutePressure p_start = Constants.p_atmosphere "Proposed initial pressure of the inlet";
  // Spool
  parameter Mechanics.Units.Mass m "Mass of the spool";
  parameter Mechanics.Units.TranslationalSpringConstant c "Stiffness of the spring";
  parameter Mechanics.Units.Force F_preload "Force of the spring at position 0, pushes the spool shut";
  parameter Mechanics.Units.TranslationalDampingConstant d "Damping";
  parameter Mechanics.Units.Position s_max "Position of the upper end stop; the lower one is at 0";
  // Edge
  parameter Mechanics.Units.Length overlap "Covered length at position 0";
  parameter Units.Diameter d_edge "Diameter of the spool at its edge";
  parameter Units.Fraction coverage "Part of the circumference that is port";
  parameter Mechanics.Units.Length clearance = 10e-6 "Radial clearance; chosen: usual for transmission spools";
  parameter Mechanics.Units.Angle jetAngle = 1.2042771838760873 "Angle of the jet to the axis; von Mises: 69 degrees";
  parameter Boolean hasFlowForce = true "true: the jet pulls its edge shut" annotation(Evaluate = true);
  parameter Units.Volume V_inlet "Volume of the inlet";
  // Connections
  Interfaces.Port inlet "Inlet, whose pressure the valve limits";
  Interfaces.Port drain "Drain";
  Mechanics.Translational.Interfaces.Flange flange "What else acts on the spool";
  Mechanics.Units.Mass m_oil "Mass of oil and air in the inlet";
  // Parts
  replaceable model SpoolModel = Components.Spool constrainedby Interfaces.PartialSpool "Law of motion"
    annotation(choicesAllMatching = true);
  replaceable model Inlet = Components.Volume constrainedby Interfaces.PartialNode "Volume of the inlet, or none"
    annotation(choicesAllMatching = true);
  SpoolModel spool(
    final m = m,
    final c = c,
    final F_preload = F_preload,
    final d = d,
    final s_max = s_max,
    final s_start = Functions.restPosition(F_preload, c, 1e6, 0, s_max)) "Spool with spring and end stops";
  Components.SpoolEdge edge(
    final fluid = fluid,
    final overlap = overlap,
    final d = d_edge,
    final coverage = coverage,
    final clearance = clearance,
    final jetAngle = jetAngle,
    final hasFlowForce = hasFlowForce) "Inlet to drain";
  Inlet volume(
    final fluid = fluid,
    final p_start = p_start,
    n = 2,
    final V_0 = V_inlet) "Inlet";
equation
  // Oil
  connect(inlet, volume.port[1]);
  connect(volume.port[2], edge.port_a);
  connect(edge.port_b, drain);
  m_oil = volume.m;
  // One rigid spool
  connect(spool.flange, edge.flange);
  connect(spool.flange, flange);
  annotation(Documentation(info = "<html>
<p>Add the feedback of the inlet's pressure at <code>flange</code>. States: what the spool model has, and the pressure of
the inlet.</p>
</html>"));
end ReliefValve;
