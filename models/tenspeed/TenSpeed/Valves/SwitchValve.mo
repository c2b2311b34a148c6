within TenSpeed.Valves;
model SwitchValve "Switch valve: pilot pressure connects the outlet to the supply, else it is drained"
  extends Interfaces.PartialThreeWay;
  parameter Mechanics.Units.Mass m = 10e-3 "Mass of the spool; chosen: aluminium, 10 mm by 50 mm, hollow";
  parameter Mechanics.Units.TranslationalSpringConstant c = 2e3 "Stiffness of the spring; chosen: 8 N over the stroke";
  parameter Mechanics.Units.TranslationalDampingConstant d = 5 "Damping; chosen: oil film of 10 micrometres";
  parameter Mechanics.Units.Force F_preload = 20 "Force of the spring at position 0; chosen: threshold between 2 and 3 bar";
  parameter Mechanics.Units.Position s_max = 4e-3 "Stroke; chosen: usual for switch valves";
  parameter Hydraulics.Units.Area A_pilot = 78.5e-6 "Land of the pilot pressure; chosen: 10 mm spool";
  parameter Hydraulics.Units.Volume V_outlet = 50e-6 "Volume of the outlet; chosen: line to a clutch";
  Hydraulics.Interfaces.Port pilot "Pilot pressure";
  Hydraulics.Units.MassFlowRate m_pilot "Mass flow in from the pilot";
  replaceable model Stage = SwitchStage constrainedby Interfaces.PartialSwitchStage "Level of the valve"
    annotation(choicesAllMatching = true);
  Stage stage(
    final fluid = fluid,
    final p_start = p_start,
    final m = m,
    final c = c,
    final d = d,
    final F_preload = F_preload,
    final s_max = s_max,
    final A_pilot = A_pilot,
    final V_outlet = V_outlet) "Spool, or what stands for it";
equation
  connect(supply, stage.supply);
  connect(drain, stage.drain);
  connect(outlet, stage.outlet);
  connect(pilot, stage.pilot);
  s = stage.flange.s;
  m_oil = stage.m_oil;
  m_pilot = Hydraulics.Media.density(pilot.p, fluid)*pilot.q;
  annotation(Documentation(info = "<html>
<p>A land of the outlet's pressure helps the pilot: once open the valve stays open until the pilot has fallen further.
Rising it switches at A_pilot (p - p_0) = F_preload + c s_supply, falling A_latch (p_outlet - p_0) lower.</p>
</html>"));
end SwitchValve;
