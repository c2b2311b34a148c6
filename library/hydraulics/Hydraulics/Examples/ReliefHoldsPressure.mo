within Hydraulics.Examples;
model ReliefHoldsPressure "A flow is relieved to the tank"
  Sources.FilteredFlowStep pump(q_end = 20/60000, startTime = 0.1, T = 0.02) "Flow";
  Components.Volume line(n = 2, V_0 = 2e-4) "Line";
  Components.PressureRelief relief(p_open = 20e5, p_full = 22e5, d = 4e-3) "Valve under test";
  Sources.Tank tank "Tank";
  output Real error(unit = "1") "Flow through the valve over the flow into the line less 1, at rest";
equation
  connect(pump.port, line.port[1]);
  connect(line.port[2], relief.port_a);
  connect(relief.port_b, tank.port);
  error = relief.m_flow/(line.rho*pump.q_end) - 1;
  assert(line.p < relief.p_full, "the relief valve does not hold the pressure");
  annotation(
    experiment(StopTime = 1, Tolerance = 1e-8),
    Documentation(info = "<html>
<p>At rest all oil passes the valve, and the line stands between p_open and p_full.</p>
</html>"));
end ReliefHoldsPressure;
