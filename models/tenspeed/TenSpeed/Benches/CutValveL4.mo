within TenSpeed.Benches;
model CutValveL4 "Cut valve at level 4: pilot pressure up and down"
  extends Interfaces.CutBench(redeclare model Valve = Valves.Levels.CutValveL4);
  annotation(
    experiment(StopTime = 4.8, Tolerance = 1e-6, Interval = 1e-3),
    Documentation(info = "<html>
<p>One state.</p>
</html>"));
end CutValveL4;
