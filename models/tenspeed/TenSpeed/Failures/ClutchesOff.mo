within TenSpeed.Failures;
model ClutchesOff "All clutches and brakes are off from the start"
  extends FailingBench(line(each t_fail = -1));
  annotation(
    experiment(StopTime = 8, Tolerance = 1e-6, Interval = 1e-2),
    Documentation(info = "<html>
<p>Neither reverse nor first ever transmits more than what sticks to empty clutches: the input runs free.</p>
</html>"));
end ClutchesOff;
