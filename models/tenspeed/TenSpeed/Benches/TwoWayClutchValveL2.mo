within TenSpeed.Benches;
model TwoWayClutchValveL2 "Two-way-clutch valve at level 2: to drive and back"
  extends Interfaces.TwoWayClutchBench(redeclare model Valve = Valves.Levels.TwoWayClutchValveL2);
  annotation(
    experiment(StopTime = 12.2, Tolerance = 1e-6, Interval = 1e-3),
    Documentation(info = "<html>
<p>8 states.</p>
</html>"));
end TwoWayClutchValveL2;
