within Hydraulics.Examples;
model CheckValveFlow "Check valve under a pressure difference that changes sign"
  Sources.PressureSource left(p_start = 1e5, p_end = 11e5, startTime = 0, duration = 1) "Rising pressure";
  Components.CheckValve valve(d = 5e-3) "Valve under test";
  Sources.Tank right(p_tank = 6e5) "Constant pressure";
  output Real error(unit = "1") "Relative difference to the open orifice, or what leaks back over its flow";
protected
  Units.MassFlowRate open "Flow of the open orifice";
equation
  connect(left.port, valve.port_a);
  connect(valve.port_b, right.port);
  open = valve.C_d*Constants.pi*valve.d^2/4*sqrt(2*valve.rho*noEvent(max(abs(valve.dp), valve.dp_full)));
  error = noEvent(
    if valve.dp > valve.dp_full then valve.m_flow/open - 1
    elseif valve.dp < 0 then valve.m_flow/open
    else 0);
  annotation(
    experiment(StopTime = 1, Tolerance = 1e-8),
    Documentation(info = "<html>
<p>Open, the flow is C_d A sqrt(2 rho dp); shut, a millionth of it leaks back.</p>
</html>"));
end CheckValveFlow;
