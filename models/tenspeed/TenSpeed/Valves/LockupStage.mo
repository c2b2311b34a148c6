within TenSpeed.Valves;
model LockupStage "Spool of the lock-up control valve with feedback and command chambers"
  extends Interfaces.PartialLockupStage;
  replaceable model SpoolModel = Hydraulics.Components.Spool
    constrainedby Hydraulics.Interfaces.PartialSpool "Law of motion" annotation(choicesAllMatching = true);
  replaceable model Feedback = Hydraulics.Components.OrificeFeedback
    constrainedby Hydraulics.Interfaces.PartialFeedback "Chambers of the feedback" annotation(choicesAllMatching = true);
  Hydraulics.Valves.ThreeWayValve valve(
    redeclare model SpoolModel = SpoolModel,
    final fluid = fluid,
    final p_start = p_start,
    final m = m,
    final d = d,
    c = 5e3,
    F_preload = 20,
    s_max = 1e-3,
    s_supply = 0.3e-3,
    s_drain = 0.3e-3,
    d_edge = 12e-3,
    coverage = 0.1,
    V_outlet = 200e-6) "Spool, edges and outlet";
  Feedback feedback1(
    final fluid = fluid,
    final p_start = p_start,
    pushes = Hydraulics.Types.Direction.Negative,
    A = 100e-6,
    V_0 = 5e-6,
    d_orifice = 2.5e-3) "Outlet pressure closes";
  Feedback feedback2(
    final fluid = fluid,
    final p_start = p_start,
    A = 150e-6,
    V_0 = 8e-6,
    d_orifice = 3e-3) "Command opens";
equation
  connect(supply, valve.supply);
  connect(drain, valve.drain);
  connect(outlet, valve.outlet);
  connect(valve.outlet, feedback1.port);
  connect(command, feedback2.port);
  connect(feedback1.flange, valve.flange);
  connect(feedback2.flange, valve.flange);
  s = valve.spool.s;
  m_oil = valve.m_oil + feedback1.m + feedback2.m;
  annotation(Documentation(info = "<html>
<p>A_1 (p_outlet - p_0) = A_2 (p_command - p_0) - F_preload - c s: nothing below 1.4 bar of command, then 1.5 bar for each
bar. Lands, spring and edges: chosen, full pressure within the range of a solenoid.</p>
</html>"));
end LockupStage;
