within TenSpeed.Benches;
model GearboxL2 "Shift sweep of the gearbox at level 2"
  extends Interfaces.GearboxBench(redeclare Gearbox.Level2 gearbox);
  annotation(
    experiment(StopTime = 50, Tolerance = 1e-6, Interval = 1e-3),
    Documentation(info = "<html>
<p>39 states.</p>
</html>"));
end GearboxL2;
