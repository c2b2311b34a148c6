within TenSpeed.Valves;
model MainMap "Main regulator at level 5: the line's pressure sets how far the edges are open"
  extends Interfaces.PartialMainStage(line(p(start = 10e5)));
  parameter Hydraulics.Units.PressureDifference p_closed = 5.81e5
    "Line above the atmosphere at which the edges begin to open, without pilot; calibrated on MainRegulatorFlowL1";
  parameter Mechanics.Units.Ratio gain = 1.5 "Line pressure per pilot pressure; ratio of the lands";
  parameter Real stiffness(unit = "Pa/m") = 5.87e7 "Rise of the line's pressure per opening; calibrated likewise";
  parameter Hydraulics.Units.AbsolutePressure p_0 = 101325 "Atmosphere";
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
  Mechanics.Translational.Sources.PositionSignal opening "Of all edges";
equation
  // Opening
  s = smooth(0, noEvent(max(0, (line.p - p_0 - p_closed - gain*(pilot.p - p_0))/stiffness)));
  opening.s = s;
  connect(opening.flange, converterEdge.flange);
  connect(opening.flange, lubricationEdge.flange);
  connect(opening.flange, suctionEdge.flange);
  // Oil
  connect(line, converterEdge.port_a);
  connect(line, lubricationEdge.port_a);
  connect(line, suctionEdge.port_a);
  connect(converterEdge.port_b, converter);
  connect(lubricationEdge.port_b, lubrication);
  connect(suctionEdge.port_b, suction);
  pilot.q = 0;
  m_oil = 0;
  annotation(Documentation(info = "<html>
<p>s = (p_line - p_0 - p_closed - gain (p_pilot - p_0)) / stiffness, not below 0. Spool, chambers and line have no
state: fed by a flow the line's pressure is what makes the edges take that flow.</p>
</html>"));
end MainMap;
