within TenSpeed.Valves;
model MainMap "Main regulator at level 5: the line's pressure sets how far the edges are open"
  extends Interfaces.PartialMainStage(line(p(start = 10e5)));
  parameter Hydraulics.Units.PressureDifference p_closed = 5.81e5
    "Line above the atmosphere at which the edges begin to open, without pilot; calibrated on MainRegulatorFlowL1";
  parameter Mechanics.Units.Ratio gain = 1.5 "Line pressure per pilot pressure; ratio of the lands";
  parameter Real stiffness(unit = "Pa/m") = 5.87e7 "Rise of the line's pressure per opening; calibrated likewise";
  parameter Mechanics.Units.Position s_round = 10e-6 "Rounding of the lower stop; chosen: the clearance";
  parameter Mechanics.Units.Position x_stiff = 0.1 "Opening at which the stiffness has doubled; chosen: without effect";
  parameter Hydraulics.Units.AbsolutePressure p_0 = 101325 "Atmosphere";
  constant Mechanics.Units.Position x_open = 0.3e-3 "Overlap of the edge that opens first";
  constant Mechanics.Units.Ratio closed = 100
    "Slope of x over y below x_open; chosen: flows change with y as they do above, none of them depends on it";
  Hydraulics.Components.SpoolEdge converterEdge(
    final fluid = fluid,
    overlap = 0.3e-3,
    d = 20e-3,
    coverage = 0.5,
    chamfer = 0.2e-3,
    hasFlowForce = false) "Line to converter, as MainStage";
  Hydraulics.Components.SpoolEdge lubricationEdge(
    final fluid = fluid,
    overlap = 0.45e-3,
    d = 20e-3,
    coverage = 0.5,
    chamfer = 0.2e-3,
    hasFlowForce = false) "Line to lubrication, as MainStage";
  Hydraulics.Components.SpoolEdge suctionEdge(
    final fluid = fluid,
    overlap = 0.6e-3,
    d = 20e-3,
    coverage = 0.5,
    chamfer = 0.2e-3,
    hasFlowForce = false) "Line to the pump's inlet, as MainStage";
  Hydraulics.Components.LaminarOrifice leakage(
    final fluid = fluid,
    d = 0.3e-3,
    l = 10e-3) "Through the clearances; chosen: 0.05 l/min at 10 bar";
  Mechanics.Translational.Sources.PositionSignal opening "Of all edges";
  Mechanics.Units.Position x "Position without the lower stop";
  Mechanics.Units.Position y(start = 0.5e-3, nominal = 1e-3) "What x is a function of, steeper where no edge is open";
equation
  // Opening
  x = y - (closed - 1)*Hydraulics.Functions.positivePart(x_open - y, s_round);
  line.p = p_0 + p_closed + gain*(pilot.p - p_0) + stiffness*x*(1 + (x/x_stiff)^2);
  s = Hydraulics.Functions.positivePart(x, s_round);
  opening.s = s;
  connect(opening.flange, converterEdge.flange);
  connect(opening.flange, lubricationEdge.flange);
  connect(opening.flange, suctionEdge.flange);
  // Oil
  connect(line, converterEdge.port_a);
  connect(line, lubricationEdge.port_a);
  connect(line, suctionEdge.port_a);
  connect(line, leakage.port_a);
  connect(leakage.port_b, suction);
  connect(converterEdge.port_b, converter);
  connect(lubricationEdge.port_b, lubrication);
  connect(suctionEdge.port_b, suction);
  pilot.q = 0;
  m_oil = 0;
  annotation(Documentation(info = "<html>
<p>p_line = p_0 + p_closed + gain (p_pilot - p_0) + stiffness x, the edges open by s = x, but not below 0. Spool, chambers
and line have no state. The pressure and the opening are explicit functions of y, on
which a solver iterates: flows change with y in the same measure whether the edges are open or shut, so Newton's method
finds its way from one to the other. Fed by a flow the line's pressure is what makes the edges take that flow.</p>
</html>"));
end MainMap;
