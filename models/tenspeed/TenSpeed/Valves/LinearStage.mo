within TenSpeed.Valves;
model LinearStage "Spool of a linear solenoid valve with pressure feedback"
  extends Interfaces.PartialSolenoidStage;
  parameter Hydraulics.Units.Area A_feedback = 32e-6 "Feedback land; chosen: 9.4 bar at 1 A and 30 N/A";
  parameter Hydraulics.Units.Volume V_feedback = 1e-6 "Feedback chamber; chosen: land and drilling";
  parameter Hydraulics.Units.Diameter d_feedback = 1e-3 "Feedback orifice; chosen: without effect below 100 Hz";
  parameter Hydraulics.Units.Diameter d_edge = 8e-3 "Spool at its edges; chosen: usual for solenoid valves";
  parameter Hydraulics.Units.Fraction coverage = 0.3 "Part of the circumference that is port; chosen: stable";
  parameter Mechanics.Units.Position s_supply = 0.055e-3
    "Supply edge opens; chosen, with s_drain: pressure proportional to current within 1 %";
  parameter Mechanics.Units.Position s_drain = 0.07e-3 "Drain edge closes; chosen: as s_supply";
  parameter Mechanics.Units.Position s_max = 0.4e-3 "Upper end stop; chosen: fills a clutch within 0.2 s";
  replaceable model SpoolModel = Hydraulics.Components.Spool
    constrainedby Hydraulics.Interfaces.PartialSpool "Law of motion" annotation(choicesAllMatching = true);
  replaceable model Feedback = Hydraulics.Components.OrificeFeedback
    constrainedby Hydraulics.Interfaces.PartialFeedback "Feedback" annotation(choicesAllMatching = true);
  Hydraulics.Valves.ThreeWayValve valve(
    redeclare model SpoolModel = SpoolModel,
    final fluid = fluid,
    final p_start = p_start,
    final m = m,
    final c = c,
    final F_preload = -F_preload,
    final d = d,
    final s_max = s_max,
    final s_supply = s_supply,
    final s_drain = s_drain,
    final d_edge = d_edge,
    final coverage = coverage,
    final V_outlet = V_outlet) "Spool, edges and outlet";
  Feedback feedback(
    final fluid = fluid,
    final p_start = p_start,
    final pushes = Hydraulics.Types.Direction.Negative,
    final A = A_feedback,
    final V_0 = V_feedback,
    final d_orifice = d_feedback) "Outlet pressure on the feedback land";
equation
  connect(supply, valve.supply);
  connect(drain, valve.drain);
  connect(outlet, valve.outlet);
  connect(valve.outlet, feedback.port);
  connect(feedback.flange, valve.flange);
  connect(flange, valve.flange);
  s = valve.spool.s;
  m_oil = valve.m_oil + feedback.m;
  annotation(Documentation(info = "<html>
<p>k_F i + F_preload = c s + A_feedback (p_feedback - p_0) + flow forces at rest. The spring pushes the spool open with
F_preload at position 0 and relaxes at F_preload/c, where the edges balance: so the pressure is proportional to the
current from zero on.</p>
</html>"));
end LinearStage;
