within TenSpeed.Failures;
model FrictionLost "The plates of B1 have lost their friction"
  extends FailingBench(gearbox(B1(mu_0 = 1e-3, K_1 = 1e-3, K_3 = 0)));
  annotation(
    experiment(StopTime = 10, Tolerance = 1e-6, Interval = 1e-2),
    Documentation(info = "<html>
<p>Oil on dry plates, or burnt ones: first is engaged at 6 s, but B1 slips, and the input runs away.</p>
</html>"));
end FrictionLost;
