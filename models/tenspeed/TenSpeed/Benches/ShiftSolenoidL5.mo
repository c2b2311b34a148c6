within TenSpeed.Benches;
model ShiftSolenoidL5 "Shift solenoid valve at level 5: pressure over current, in steps up and down"
  extends Interfaces.SolenoidBench(redeclare model Valve = Valves.Levels.ShiftSolenoidL5);
  annotation(
    experiment(StopTime = 4.2, Tolerance = 1e-6, Interval = 1e-3),
    Documentation(info = "<html>
<p>No state.</p>
</html>"));
end ShiftSolenoidL5;
