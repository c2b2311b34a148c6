within TenSpeed.Interfaces;
partial model PartialReliefRegulator "Regulator that drains what is too much, with the volume of its line"
  extends PartialRegulator;
  Hydraulics.Interfaces.Port inlet "Line, whose pressure the valve regulates";
  Hydraulics.Interfaces.Port drain "Outlet for what is too much";
  Hydraulics.Units.MassFlowRate m_in "Mass flow in";
  Hydraulics.Units.MassFlowRate m_out "Mass flow out to the drain";
  replaceable model Stage = Valves.LubricationStage constrainedby PartialReliefStage "Level of the valve"
    annotation(choicesAllMatching = true);
  Stage stage(
    final fluid = fluid,
    final p_start = p_start,
    final m = m,
    final d = d) "Spool, or what stands for it";
equation
  connect(inlet, stage.inlet);
  connect(drain, stage.drain);
  s = stage.s;
  m_oil = stage.m_oil;
  // Mass flows at the ports
  m_in = Hydraulics.Media.density(inlet.p, fluid)*inlet.q;
  m_out = -Hydraulics.Media.density(drain.p, fluid)*drain.q;
  annotation(Documentation(info = "<html>
<p>d m_oil/dt = m_in - m_out.</p>
</html>"));
end PartialReliefRegulator;
