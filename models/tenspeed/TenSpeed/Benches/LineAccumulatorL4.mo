within TenSpeed.Benches;
model LineAccumulatorL4 "Line-pressure accumulator valve at level 4: the line rises to 12 bar"
  extends Interfaces.AccumulatorBench(redeclare model Valve = Valves.Levels.LineAccumulatorL4);
  annotation(
    experiment(StopTime = 0.6, Tolerance = 1e-6, Interval = 1e-3),
    Documentation(info = "<html>
<p>No state.</p>
</html>"));
end LineAccumulatorL4;
