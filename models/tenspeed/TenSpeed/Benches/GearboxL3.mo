within TenSpeed.Benches;
model GearboxL3 "Shift sweep of the gearbox at level 3"
  extends Interfaces.GearboxBench(redeclare Gearbox.Level3 gearbox);
  annotation(
    experiment(StopTime = 50, Tolerance = 1e-6, Interval = 1e-3),
    Documentation(info = "<html>
<p>37 states.</p>
</html>"));
end GearboxL3;
