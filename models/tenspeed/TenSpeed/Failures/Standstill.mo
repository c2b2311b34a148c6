within TenSpeed.Failures;
model Standstill "The output is held while the input drives, in reverse and in first"
  extends FailingBench(holdingForce = 40000);
  annotation(
    experiment(StopTime = 8, Tolerance = 1e-6, Interval = 1e-2),
    Documentation(info = "<html>
<p>Everything but what slips stands still under torque; no clutch leaves its state again and again.</p>
</html>"));
end Standstill;
