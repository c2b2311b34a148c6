within TenSpeed.Benches;
model GearboxL4 "Shift sweep of the gearbox at level 4"
  extends Interfaces.GearboxBench(redeclare Gearbox.Level4 gearbox);
  annotation(
    experiment(StopTime = 50, Tolerance = 1e-6, Interval = 1e-3),
    Documentation(info = "<html>
<p>29 states.</p>
</html>"));
end GearboxL4;
