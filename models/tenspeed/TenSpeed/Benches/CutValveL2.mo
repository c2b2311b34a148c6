within TenSpeed.Benches;
model CutValveL2 "Cut valve at level 2: pilot pressure up and down"
  extends Interfaces.CutBench(redeclare model Valve = Valves.Levels.CutValveL2);
  annotation(
    experiment(StopTime = 4.8, Tolerance = 1e-6, Interval = 1e-3),
    Documentation(info = "<html>
<p>3 states.</p>
</html>"));
end CutValveL2;
