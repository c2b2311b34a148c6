within TenSpeed.Benches;
model LineAccumulatorL1 "Line-pressure accumulator valve at level 1: the line rises to 12 bar"
  extends Interfaces.AccumulatorBench(redeclare model Valve = Valves.Levels.LineAccumulatorL1);
  annotation(
    experiment(StopTime = 0.6, Tolerance = 1e-6, Interval = 1e-3),
    Documentation(info = "<html>
<p>3 states.</p>
</html>"));
end LineAccumulatorL1;
