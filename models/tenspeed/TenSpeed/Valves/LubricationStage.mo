within TenSpeed.Valves;
model LubricationStage "Spool of the lubrication regulator with its feedback and line"
  extends Interfaces.PartialReliefStage;
  replaceable model SpoolModel = Hydraulics.Components.Spool
    constrainedby Hydraulics.Interfaces.PartialSpool "Law of motion" annotation(choicesAllMatching = true);
  replaceable model Feedback = Hydraulics.Components.OrificeFeedback
    constrainedby Hydraulics.Interfaces.PartialFeedback "Chambers of the feedback" annotation(choicesAllMatching = true);
  Hydraulics.Valves.ReliefValve valve(
    redeclare model SpoolModel = SpoolModel,
    final fluid = fluid,
    final p_start = p_start,
    final m = m,
    final d = d,
    c = 1.5e3,
    F_preload = 80,
    s_max = 3e-3,
    overlap = 0.3e-3,
    d_edge = 22e-3,
    coverage = 0.4,
    jetAngle = 1.4,
    V_inlet = 500e-6) "Spool, edge and line";
  Feedback feedback(
    final fluid = fluid,
    final p_start = p_start,
    A = 400e-6,
    V_0 = 20e-6,
    d_orifice = 4e-3) "Opens the valve";
equation
  connect(inlet, valve.inlet);
  connect(valve.drain, drain);
  connect(valve.inlet, feedback.port);
  connect(feedback.flange, valve.flange);
  s = valve.spool.s;
  m_oil = valve.m_oil + feedback.m;
  annotation(Documentation(info = "<html>
<p>A (p - p_0) = F_preload + c s + flow force. Where the numbers come from: land, spring and edge chosen so that the line
stands within 3 % of 2 bar up to 20 l/min; the jet turned by a recess in the spool (80 degrees to the axis, half the
flow force of a sharp edge); the orifice so wide that it hardly delays.</p>
</html>"));
end LubricationStage;
