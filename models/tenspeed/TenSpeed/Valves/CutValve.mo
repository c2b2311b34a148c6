within TenSpeed.Valves;
model CutValve "Cut valve: as a switch valve, and drains four more lines when switched"
  extends SwitchValve;
  parameter Mechanics.Units.Position s_cut = 2.2e-3 "Position at which the lines are drained; chosen: as the supply edge";
  parameter Hydraulics.Units.Diameter d_cut = 10e-3 "Spool at these edges; chosen: as the others";
  parameter Hydraulics.Units.Fraction coverage_cut = 0.06
    "Part of the circumference that is port; chosen: 2 mm, flow forces below the latch's";
  constant Integer n = 4 "Lines: three clutches and the pilot of the line pressure";
  Hydraulics.Interfaces.Port line[n] "Lines that are drained";
  Hydraulics.Units.MassFlowRate m_lines "Mass flow in from the lines";
  Hydraulics.Components.SpoolEdge cut[n](
    each final fluid = fluid,
    each final overlap = s_cut,
    each final d = d_cut,
    each final coverage = coverage_cut) "Lines to drain";
equation
  for k in 1:n loop
    connect(line[k], cut[k].port_a);
    connect(cut[k].port_b, drain);
    connect(cut[k].flange, stage.flange);
  end for;
  m_lines = sum(Hydraulics.Media.density(line[k].p, fluid)*line[k].q for k in 1:n);
  annotation(Documentation(info = "<html>
<p>Six edges: two as in <code>SwitchValve</code>, and one for each of three clutch lines and the pilot of the line
pressure.</p>
</html>"));
end CutValve;
