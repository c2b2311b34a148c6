within TenSpeed.Valves;
model MainRegulator "Main regulator valve with the volume of its line"
  extends Interfaces.PartialRegulator;
  Hydraulics.Interfaces.Port line "Line, whose pressure the valve regulates";
  Hydraulics.Interfaces.Port pilot "Pilot pressure";
  Hydraulics.Interfaces.Port converter "Outlet that opens first, to the torque converter";
  Hydraulics.Interfaces.Port lubrication "Outlet that opens second, to lubrication";
  Hydraulics.Interfaces.Port suction "Outlet that opens last, back to the pump's inlet";
  Hydraulics.Units.MassFlowRate m_in "Mass flow in from line and pilot";
  Hydraulics.Units.MassFlowRate m_out "Mass flow out of the three outlets";
  replaceable model Stage = MainStage constrainedby Interfaces.PartialMainStage "Level of the valve"
    annotation(choicesAllMatching = true);
  Stage stage(
    final fluid = fluid,
    final p_start = p_start,
    final m = m,
    final d = d) "Spool, or what stands for it";
equation
  connect(line, stage.line);
  connect(pilot, stage.pilot);
  connect(converter, stage.converter);
  connect(lubrication, stage.lubrication);
  connect(suction, stage.suction);
  s = stage.s;
  m_oil = stage.m_oil;
  // Mass flows at the ports
  m_in = Hydraulics.Media.density(line.p, fluid)*line.q + Hydraulics.Media.density(pilot.p, fluid)*pilot.q;
  m_out = -Hydraulics.Media.density(converter.p, fluid)*converter.q
    - Hydraulics.Media.density(lubrication.p, fluid)*lubrication.q
    - Hydraulics.Media.density(suction.p, fluid)*suction.q;
  annotation(Documentation(info = "<html>
<p>Fed by a flow the line's pressure is a state, at a prescribed pressure the compiler removes it. d m_oil/dt = m_in -
m_out.</p>
</html>"));
end MainRegulator;
