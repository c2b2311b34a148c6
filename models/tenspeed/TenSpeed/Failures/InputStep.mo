within TenSpeed.Failures;
model InputStep "The input torque jumps in second gear"
  extends FailingBench(inputStep = 250);
  annotation(
    experiment(StopTime = 10, Tolerance = 1e-6, Interval = 1e-2),
    Documentation(info = "<html>
<p>150 N.m become 400 N.m at once: more than the clutches were made for, but not more than they hold.</p>
</html>"));
end InputStep;
