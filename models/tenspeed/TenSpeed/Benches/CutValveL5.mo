within TenSpeed.Benches;
model CutValveL5 "Cut valve at level 5: pilot pressure up and down"
  extends Interfaces.CutBench(redeclare model Valve = Valves.Levels.CutValveL5);
  annotation(
    experiment(StopTime = 4.8, Tolerance = 1e-6, Interval = 1e-3),
    Documentation(info = "<html>
<p>No state.</p>
</html>"));
end CutValveL5;
