within TenSpeed.Valves;
model TwoWayClutchValve "Two-way-clutch valve: two pressures push to drive, two to reverse, detents hold both positions"
  replaceable package Oil = Hydraulics.Media.OilDexronVI constrainedby Hydraulics.Media.PartialOil
    "Oil whose data are the default" annotation(choicesAllMatching = true);
  parameter Hydraulics.Media.Fluid fluid = Oil.data "Oil";
  parameter Hydraulics.Units.AbsolutePressure p_start = 101325 "Proposed initial pressures";
  parameter Mechanics.Units.Mass m = 50e-3 "Mass of the spool and of what it moves; chosen: steel, 12 mm by 60 mm";
  parameter Mechanics.Units.TranslationalDampingConstant d = 10 "Damping; chosen: seals and oil film";
  parameter Mechanics.Units.Length stroke = 8e-3 "Distance of the two positions; chosen: of the clutch's selector plate";
  parameter Hydraulics.Units.Area A = 40e-6 "Land of each chamber; chosen: 7 mm";
  parameter Mechanics.Units.Length hump = 1e-3 "Height of the detents' cam half-way; chosen: slope of 21 degrees";
  parameter Mechanics.Units.Force F_detent = 15 "Force of each detent's spring at rest; chosen: passes at 2 bar";
  parameter Mechanics.Units.TranslationalSpringConstant c_detent = 10e3
    "Stiffness of each detent's spring; chosen: 10 N more on the hump";
  Hydraulics.Interfaces.Port drive[2] "Pressures that push to drive";
  Hydraulics.Interfaces.Port reverse[2] "Pressures that push to reverse";
  Mechanics.Units.Position s "Position: 0 in reverse, stroke in drive";
  Mechanics.Units.Mass m_oil "Mass of oil and air inside";
  Hydraulics.Units.MassFlowRate m_in "Mass flow in";
  replaceable model Stage = TwoWayClutchStage constrainedby Interfaces.PartialTwoWayClutchStage "Level of the valve"
    annotation(choicesAllMatching = true);
  Stage stage(
    final fluid = fluid,
    final p_start = p_start,
    final m = m,
    final d = d,
    final stroke = stroke,
    final A = A,
    final hump = hump,
    final F_detent = F_detent,
    final c_detent = c_detent) "Spool, or what stands for it";
equation
  connect(drive, stage.drive);
  connect(reverse, stage.reverse);
  s = stage.s;
  m_oil = stage.m_oil;
  m_in = sum(Hydraulics.Media.density(drive[k].p, fluid)*drive[k].q
    + Hydraulics.Media.density(reverse[k].p, fluid)*reverse[k].q for k in 1:2);
  annotation(Documentation(info = "<html>
<p>Without pressure the detents hold the spool in either position; it passes when the pressures' force exceeds the largest
force of both detents on the way, 2 (F_detent + c_detent h) dh/ds. d m_oil/dt = m_in.</p>
</html>"));
end TwoWayClutchValve;
