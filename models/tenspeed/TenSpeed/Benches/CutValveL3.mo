within TenSpeed.Benches;
model CutValveL3 "Cut valve at level 3: pilot pressure up and down"
  extends Interfaces.CutBench(redeclare model Valve = Valves.Levels.CutValveL3);
  annotation(
    experiment(StopTime = 4.8, Tolerance = 1e-6, Interval = 1e-3),
    Documentation(info = "<html>
<p>2 states.</p>
</html>"));
end CutValveL3;
