within TenSpeed.Benches;
model TwoWayClutchValveL3 "Two-way-clutch valve at level 3: to drive and back"
  extends Interfaces.TwoWayClutchBench(redeclare model Valve = Valves.Levels.TwoWayClutchValveL3);
  annotation(
    experiment(StopTime = 12.2, Tolerance = 1e-6, Interval = 1e-3),
    Documentation(info = "<html>
<p>One state.</p>
</html>"));
end TwoWayClutchValveL3;
