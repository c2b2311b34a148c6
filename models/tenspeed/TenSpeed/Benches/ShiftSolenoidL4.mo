within TenSpeed.Benches;
model ShiftSolenoidL4 "Shift solenoid valve at level 4: pressure over current, in steps up and down"
  extends Interfaces.SolenoidBench(redeclare model Valve = Valves.Levels.ShiftSolenoidL4);
  annotation(
    experiment(StopTime = 4.2, Tolerance = 1e-6, Interval = 1e-3),
    Documentation(info = "<html>
<p>One state.</p>
</html>"));
end ShiftSolenoidL4;
