within TenSpeed.Benches;
model TwoWayClutchValveL5 "Two-way-clutch valve at level 5: to drive and back"
  extends Interfaces.TwoWayClutchBench(redeclare model Valve = Valves.Levels.TwoWayClutchValveL5);
  annotation(
    experiment(StopTime = 12.2, Tolerance = 1e-6, Interval = 1e-3),
    Documentation(info = "<html>
<p>No state.</p>
</html>"));
end TwoWayClutchValveL5;
