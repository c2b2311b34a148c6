within Hydraulics.Examples;
model PumpAgainstOrifice "A slipping pump and a laminar load share the displaced flow"
  Sources.SlippingPump pump(
    q_start = 0,
    q_end = 1e-4,
    startTime = 0.1,
    duration = 0.5,
    p_shutOff = 10e5) "Pump under test";
  Components.LaminarOrifice load(d = 2e-3, l = 0.1) "Load";
  Sources.Tank tank "Tank";
  output Real error(unit = "1") "Imbalance of the displaced flow over its final value";
equation
  connect(pump.port, load.port_a);
  connect(load.port_b, tank.port);
  // Displaced flow: load and slip, each linear in the pressure difference but for the oil's compression
  error = (pump.q + pump.slip*(pump.port.p - pump.p_inlet)
    - pump.q_end*Mechanics.Functions.smoothStep((time - pump.startTime)/pump.duration))/pump.q_end;
  annotation(
    experiment(StopTime = 1, Tolerance = 1e-8),
    Documentation(info = "<html>
<p>The pressure stays below the shut-off pressure and is proportional to the displaced flow.</p>
</html>"));
end PumpAgainstOrifice;
