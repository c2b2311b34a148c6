within Hydraulics.Examples;
model ThreeWaySpool "A force moves a three-way valve, a map does the same without a spool"
  Sources.PressureSource supply(p_start = 10e5) "Supply";
  Sources.Tank drain "Drain";
  Mechanics.Translational.Sources.Force actuator(f_start = 0, f_end = 12, startTime = 0.05, duration = 0.2) "Actuator";
  Valves.ThreeWayValve valve(
    m = 0.01,
    c = 2e3,
    F_preload = 2,
    d = 10,
    s_max = 4e-3,
    s_supply = 2.2e-3,
    s_drain = 1.8e-3,
    d_edge = 8e-3,
    coverage = 0.3,
    V_outlet = 50e-6) "Valve under test";
  Valves.ThreeWayMap map "Map under test";
  Components.Volume line(n = 1, V_0 = 50e-6) "Line behind the map";
  output Real error(unit = "1") "Difference of both outlet pressures over the supply's, zero at rest";
equation
  connect(supply.port, valve.supply);
  connect(valve.drain, drain.port);
  connect(actuator.flange, valve.flange);
  connect(supply.port, map.supply);
  connect(map.drain, drain.port);
  connect(map.outlet, line.port[1]);
  map.w = Mechanics.Functions.smoothStep((time - 0.05)/0.2);
  error = (valve.outlet.p - line.p)/supply.port.p;
  annotation(
    experiment(StopTime = 0.6, Tolerance = 1e-6),
    Documentation(info = "<html>
<p>Closed outlets, at the supply's pressure in the end but for the leakage through the drain's clearance.</p>
</html>"));
end ThreeWaySpool;
