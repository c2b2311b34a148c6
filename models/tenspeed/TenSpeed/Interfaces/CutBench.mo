within TenSpeed.Interfaces;
partial model CutBench "Cut valve alone, its lines at prescribed pressures"
  extends SwitchBench(redeclare replaceable model Valve = Valves.CutValve constrainedby Valves.CutValve);
  Hydraulics.Sources.PressureSource line[4](each p_start = 8e5) "Pressures of the lines; chosen: clutches half engaged";
  output Hydraulics.Units.MassFlowRate drained = valve.m_lines "Mass flow out of the lines";
equation
  connect(line.port, valve.line);
  inflow = valve.m_supply + valve.m_pilot + valve.m_lines;
  annotation(Documentation(info = "<html>
<p>As <code>SwitchBench</code>, with the lines that the valve drains.</p>
</html>"));
end CutBench;
