within TenSpeed.Valves;
model ShiftStage "Plunger of a shift solenoid valve with its two edges"
  extends Interfaces.PartialSolenoidStage;
  parameter Mechanics.Units.Position s_max = 3e-3 "Stroke; nominal value of the study";
  parameter Mechanics.Units.TranslationalSpringConstant c_stop = 1e7 "End stops; nominal value of the study";
  parameter Mechanics.Units.ContactDampingConstant b_stop = 50 "Damping of the end stops; chosen: hardly any rebound";
  parameter Hydraulics.Units.Diameter d_edge = 4e-3 "Plunger at its edges; chosen: flow forces below the spring's";
  parameter Hydraulics.Units.Fraction coverage = 0.25 "Part of the circumference that is port; chosen: as d_edge";
  parameter Mechanics.Units.Position s_supply = 1.8e-3 "Supply edge opens; chosen: both are closed between";
  parameter Mechanics.Units.Position s_drain = 1.2e-3 "Drain edge closes; chosen: as s_supply";
  parameter Boolean hasFlowForce = true "true: the jets pull their edges shut" annotation(Evaluate = true);
  replaceable model SpoolModel = Hydraulics.Components.Spool
    constrainedby Hydraulics.Interfaces.PartialSpool "Law of motion" annotation(choicesAllMatching = true);
  Hydraulics.Valves.ThreeWayValve valve(
    redeclare model SpoolModel = SpoolModel,
    final fluid = fluid,
    final p_start = p_start,
    final m = m,
    final c = c,
    final F_preload = F_preload,
    final d = d,
    final s_max = s_max,
    final c_stop = c_stop,
    final b_stop = b_stop,
    final s_supply = s_supply,
    final s_drain = s_drain,
    final d_edge = d_edge,
    final coverage = coverage,
    final hasFlowForce = hasFlowForce,
    final V_outlet = V_outlet) "Plunger, edges and outlet";
equation
  connect(supply, valve.supply);
  connect(drain, valve.drain);
  connect(outlet, valve.outlet);
  connect(flange, valve.flange);
  s = valve.spool.s;
  m_oil = valve.m_oil;
  annotation(Documentation(info = "<html>
<p>k_F i = F_preload + c s + flow forces between the stops.</p>
</html>"));
end ShiftStage;
