within TenSpeed.Valves;
model SwitchStage "Spool of a switch valve with its two edges"
  extends Interfaces.PartialSwitchStage;
  parameter Hydraulics.Units.Area A_latch = 10e-6 "Land of the outlet's pressure; chosen: 1.2 bar of hysteresis at 10 bar";
  parameter Hydraulics.Units.Volume V_chamber = 0.5e-6 "Oil at each land; chosen: land and drilling";
  parameter Hydraulics.Units.Diameter d_edge = 10e-3 "Spool at its edges; chosen: usual for switch valves";
  parameter Hydraulics.Units.Fraction coverage = 0.3 "Part of the circumference that is port; chosen: 9 mm";
  parameter Mechanics.Units.Position s_supply = 2.2e-3 "Supply edge opens; chosen: behind the middle of the stroke";
  parameter Mechanics.Units.Position s_drain = 1.8e-3 "Drain edge closes; chosen: before the middle of the stroke";
  parameter Boolean hasFlowForce = true "true: the jets pull their edges shut" annotation(Evaluate = true);
  replaceable model SpoolModel = Hydraulics.Components.Spool
    constrainedby Hydraulics.Interfaces.PartialSpool "Law of motion" annotation(choicesAllMatching = true);
  replaceable model Chamber = Hydraulics.Components.SpoolChamber
    constrainedby Hydraulics.Interfaces.PartialSpoolChamber "Whether the spool displaces oil"
    annotation(choicesAllMatching = true);
  Hydraulics.Valves.ThreeWayValve valve(
    redeclare model SpoolModel = SpoolModel,
    final fluid = fluid,
    final p_start = p_start,
    final m = m,
    final c = c,
    final F_preload = F_preload,
    final d = d,
    final s_max = s_max,
    final b_stop = 20,
    final s_supply = s_supply,
    final s_drain = s_drain,
    final d_edge = d_edge,
    final coverage = coverage,
    final hasFlowForce = hasFlowForce,
    final V_outlet = V_outlet) "Spool, edges and outlet";
  Hydraulics.Components.DirectFeedback piloted(
    redeclare model Chamber = Chamber,
    final fluid = fluid,
    final p_start = p_start,
    final A = A_pilot,
    final V_0 = V_chamber) "Pilot pressure on its land";
  Hydraulics.Components.DirectFeedback latch(
    redeclare model Chamber = Chamber,
    final fluid = fluid,
    final p_start = p_start,
    final A = A_latch,
    final V_0 = V_chamber) "Outlet pressure on its land";
equation
  connect(supply, valve.supply);
  connect(drain, valve.drain);
  connect(outlet, valve.outlet);
  connect(pilot, piloted.port);
  connect(valve.outlet, latch.port);
  connect(valve.flange, piloted.flange);
  connect(valve.flange, latch.flange);
  connect(valve.flange, flange);
  m_oil = valve.m_oil + piloted.m + latch.m;
  annotation(Documentation(info = "<html>
<p>The chambers have no orifice, so their oil is one volume with the pilot's line and with the outlet: the valve alone has
the states s, v and the outlet's pressure.</p>
</html>"));
end SwitchStage;
