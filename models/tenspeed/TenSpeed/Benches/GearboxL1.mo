within TenSpeed.Benches;
model GearboxL1 "Shift sweep of the gearbox at level 1"
  extends Interfaces.GearboxBench(redeclare Gearbox.Level1 gearbox);
  annotation(
    experiment(StopTime = 50, Tolerance = 1e-6, Interval = 1e-3),
    Documentation(info = "<html>
<p>103 states.</p>
</html>"));
end GearboxL1;
