within Hydraulics.Examples;
model ReliefSpool "A relief valve holds the pressure behind a pump"
  Sources.FlowSource pump(q_start = 0, q_end = 10/60000, duration = 0.2) "Pump, 10 l/min";
  Valves.ReliefValve valve(
    m = 1e-3,
    c = 3e3,
    F_preload = 50,
    d = 50,
    s_max = 3e-3,
    overlap = 0.3e-3,
    d_edge = 16e-3,
    coverage = 0.5,
    V_inlet = 200e-6) "Valve under test";
  Components.OrificeFeedback feedback(A = 150e-6, V_0 = 2e-6, d_orifice = 2e-3) "Feedback";
  Components.Junction junction(n = 3) "Where pump and valve meet";
  Sources.Tank tank "Tank";
  output Mechanics.Units.Force error "Imbalance of forces, zero at rest";
equation
  connect(pump.port, junction.port[1]);
  connect(junction.port[2], valve.inlet);
  connect(junction.port[3], feedback.port);
  connect(feedback.flange, valve.flange);
  connect(valve.drain, tank.port);
  error = feedback.A*(valve.inlet.p - Constants.p_atmosphere) - valve.spool.springForce + valve.spool.stopForce
    - valve.edge.flowForce;
  annotation(
    experiment(StopTime = 1, Tolerance = 1e-6),
    Documentation(info = "<html>
<p>A (p - p_0) = F_preload + c s + flow force at rest.</p>
</html>"));
end ReliefSpool;
