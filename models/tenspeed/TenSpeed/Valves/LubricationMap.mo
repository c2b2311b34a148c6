within TenSpeed.Valves;
model LubricationMap "Lubrication regulator at level 5: the line's pressure sets how far the edge is open"
  extends Interfaces.PartialReliefStage(inlet(p(start = p_0 + p_closed)));
  parameter Hydraulics.Units.PressureDifference p_closed = 1.988e5
    "Line above the atmosphere at which the edge begins to open; calibrated on LubricationRegulatorL1";
  parameter Real stiffness(unit = "Pa/m") = 7.30e6 "Rise of the line's pressure per opening; calibrated likewise";
  parameter Mechanics.Units.Position s_round = 10e-6 "Rounding of the lower stop; chosen: the clearance";
  parameter Mechanics.Units.Position x_stiff = 0.1 "Opening at which the stiffness has doubled; chosen: without effect";
  parameter Hydraulics.Units.AbsolutePressure p_0 = 101325 "Atmosphere";
  constant Mechanics.Units.Position x_open = 0.3e-3 "Overlap of the edge that opens first";
  constant Mechanics.Units.Ratio closed = 100
    "Slope of x over y below x_open; chosen: flows change with y as they do above, none of them depends on it";
  Hydraulics.Components.SpoolEdge edge(
    final fluid = fluid,
    overlap = 0.3e-3,
    d = 22e-3,
    coverage = 0.4,
    hasFlowForce = false) "As LubricationStage";
  Hydraulics.Components.LaminarOrifice leakage(
    final fluid = fluid,
    d = 0.3e-3,
    l = 10e-3) "Through the clearance; chosen: 0.05 l/min at 10 bar";
  Mechanics.Translational.Sources.PositionSignal opening "Of the edge";
  Mechanics.Units.Position x "Position without the lower stop";
  Mechanics.Units.Position y(start = 0.5e-3, nominal = 1e-3) "What x is a function of, steeper where no edge is open";
equation
  // Opening
  x = y - (closed - 1)*Hydraulics.Functions.positivePart(x_open - y, s_round);
  inlet.p = p_0 + p_closed + stiffness*x*(1 + (x/x_stiff)^2);
  s = Hydraulics.Functions.positivePart(x, s_round);
  opening.s = s;
  connect(opening.flange, edge.flange);
  // Oil
  connect(inlet, edge.port_a);
  connect(edge.port_b, drain);
  connect(inlet, leakage.port_a);
  connect(leakage.port_b, drain);
  m_oil = 0;
  annotation(Documentation(info = "<html>
<p>s = (p - p_0 - p_closed) / stiffness, not below 0. Spool, chambers and line have no state. A solver
iterates on y, see <code>MainMap</code>.</p>
</html>"));
end LubricationMap;
