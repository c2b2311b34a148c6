within TenSpeed.Failures;
model OutputStep "The output is loaded suddenly in second gear"
  extends FailingBench(outputStep = -2000);
  annotation(
    experiment(StopTime = 10, Tolerance = 1e-6, Interval = 1e-2),
    Documentation(info = "<html>
<p>A wheel hits a kerb: 2,000 N.m against the motion.</p>
</html>"));
end OutputStep;
