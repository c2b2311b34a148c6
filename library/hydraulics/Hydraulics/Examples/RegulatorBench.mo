within Hydraulics.Examples;
model RegulatorBench "Main regulator valve fed by a pump"
  Sources.FlowSource pump(q_start = 0, q_end = 20/60000, duration = 0.2) "Pump, 20 l/min";
  Components.Volume line(n = 3, V_0 = 500e-6) "Line";
  Valves.MainRegulatorValve valve "Valve under test";
  Sources.PressureSource pilot(p_start = 3e5) "Pilot pressure";
  Sources.Tank converter(p_tank = 4e5) "Converter";
  Sources.Tank lubrication(p_tank = 2e5) "Lubrication";
  Sources.Tank suction "Pump inlet";
  output Mechanics.Units.Force error "Imbalance of forces on the spool, zero at rest";
equation
  connect(pump.port, line.port[1]);
  connect(line.port[2], valve.line);
  connect(line.port[3], valve.feedback);
  connect(pilot.port, valve.pilot);
  connect(valve.converter, converter.port);
  connect(valve.lubrication, lubrication.port);
  connect(valve.suction, suction.port);
  // Balance at rest, with the pressures outside the orifices
  error = valve.A_feedback*(line.p - Constants.p_atmosphere)
    - valve.A_pilot*(pilot.port.p - Constants.p_atmosphere)
    - valve.spool.springForce
    + valve.spool.stopForce
    - valve.converterEdge.flowForce
    - valve.lubricationEdge.flowForce
    - valve.suctionEdge.flowForce;
  annotation(
    experiment(StopTime = 1, Tolerance = 1e-6),
    Documentation(info = "<html>
<p>The line settles where feedback balances spring, pilot and flow forces.</p>
</html>"));
end RegulatorBench;
