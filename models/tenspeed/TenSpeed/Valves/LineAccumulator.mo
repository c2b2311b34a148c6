within TenSpeed.Valves;
model LineAccumulator "Line-pressure accumulator valve: a piston on a spring takes oil from the line"
  extends Interfaces.PartialRegulator;
  Hydraulics.Interfaces.Port port "Line";
  Hydraulics.Units.MassFlowRate m_in "Mass flow in";
  replaceable model Stage = AccumulatorStage constrainedby Interfaces.PartialAccumulatorStage "Level of the valve"
    annotation(choicesAllMatching = true);
  Stage stage(
    final fluid = fluid,
    final p_start = p_start,
    final m = m,
    final d = d) "Piston, or what stands for it";
equation
  connect(port, stage.port);
  s = stage.s;
  m_oil = stage.m_oil;
  m_in = Hydraulics.Media.density(port.p, fluid)*port.q;
  annotation(Documentation(info = "<html>
<p>d m_oil/dt = m_in.</p>
</html>"));
end LineAccumulator;
