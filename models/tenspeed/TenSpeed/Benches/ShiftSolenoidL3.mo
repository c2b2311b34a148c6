within TenSpeed.Benches;
model ShiftSolenoidL3 "Shift solenoid valve at level 3: pressure over current, in steps up and down"
  extends Interfaces.SolenoidBench(redeclare model Valve = Valves.Levels.ShiftSolenoidL3);
  annotation(
    experiment(StopTime = 4.2, Tolerance = 1e-6, Interval = 1e-3),
    Documentation(info = "<html>
<p>2 states.</p>
</html>"));
end ShiftSolenoidL3;
