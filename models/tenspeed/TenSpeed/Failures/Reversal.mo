within TenSpeed.Failures;
model Reversal "The load pulls the vehicle back through standstill, in second gear"
  extends FailingBench(t_step = 8.7, outputStep = -2500);
  annotation(
    experiment(StopTime = 10.5, Tolerance = 1e-6, Interval = 1e-2),
    Documentation(info = "<html>
<p>The speeds of all bodies pass zero while the clutches hold; the two-way clutch locks.</p>
</html>"));
end Reversal;
