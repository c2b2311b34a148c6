within TenSpeed.Valves;
model ConverterStage "Spool of the converter regulator with its feedback and line"
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
    c = 2e3,
    F_preload = 100,
    s_max = 3e-3,
    overlap = 0.3e-3,
    d_edge = 20e-3,
    coverage = 0.45,
    jetAngle = 1.35,
    V_inlet = 500e-6) "Spool, edge and line";
  Feedback feedback1(
    final fluid = fluid,
    final p_start = p_start,
    A = 300e-6,
    V_0 = 15e-6,
    d_orifice = 4e-3) "Opens the valve";
  Feedback feedback2(
    final fluid = fluid,
    final p_start = p_start,
    pushes = Hydraulics.Types.Direction.Negative,
    A = 100e-6,
    V_0 = 6e-6,
    d_orifice = 2e-3) "Closes the valve";
equation
  connect(inlet, valve.inlet);
  connect(valve.drain, drain);
  connect(valve.inlet, feedback1.port);
  connect(feedback1.flange, valve.flange);
  connect(valve.inlet, feedback2.port);
  connect(feedback2.flange, valve.flange);
  s = valve.spool.s;
  m_oil = valve.m_oil + feedback1.m + feedback2.m;
  annotation(Documentation(info = "<html>
<p>(A_1 - A_2) (p - p_0) = F_preload + c s + flow force: two lands against each other, the smaller behind a narrower
orifice. Where the numbers come from: lands, spring and edge chosen so that the line stands within 3 % of 5 bar up to
15 l/min; the jet turned by a recess in the spool (77 degrees to the axis).</p>
</html>"));
end ConverterStage;
