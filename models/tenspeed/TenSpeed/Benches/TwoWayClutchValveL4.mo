within TenSpeed.Benches;
model TwoWayClutchValveL4 "Two-way-clutch valve at level 4: to drive and back"
  extends Interfaces.TwoWayClutchBench(redeclare model Valve = Valves.Levels.TwoWayClutchValveL4);
  annotation(
    experiment(StopTime = 12.2, Tolerance = 1e-6, Interval = 1e-3),
    Documentation(info = "<html>
<p>2 states.</p>
</html>"));
end TwoWayClutchValveL4;
