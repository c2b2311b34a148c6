within TenSpeed.Valves;
model LubricationMap "Lubrication regulator at level 5: the line's pressure sets how far the edge is open"
  extends Interfaces.PartialReliefStage(inlet(p(start = p_0 + p_closed)));
  parameter Hydraulics.Units.PressureDifference p_closed = 1.988e5
    "Line above the atmosphere at which the edge begins to open; calibrated on LubricationRegulatorL1";
  parameter Real stiffness(unit = "Pa/m") = 7.30e6 "Rise of the line's pressure per opening; calibrated likewise";
  parameter Hydraulics.Units.AbsolutePressure p_0 = 101325 "Atmosphere";
  Hydraulics.Components.SpoolEdge edge(
    final fluid = fluid,
    overlap = 0.3e-3,
    d = 22e-3,
    coverage = 0.4,
    hasFlowForce = false) "As LubricationStage";
  Mechanics.Translational.Sources.PositionSignal opening "Of the edge";
equation
  // Opening
  s = smooth(0, noEvent(max(0, (inlet.p - p_0 - p_closed)/stiffness)));
  opening.s = s;
  connect(opening.flange, edge.flange);
  // Oil
  connect(inlet, edge.port_a);
  connect(edge.port_b, drain);
  m_oil = 0;
  annotation(Documentation(info = "<html>
<p>s = (p - p_0 - p_closed) / stiffness, not below 0. Spool, chambers and line have no state.</p>
</html>"));
end LubricationMap;
