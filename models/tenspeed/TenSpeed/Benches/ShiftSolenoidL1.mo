within TenSpeed.Benches;
model ShiftSolenoidL1 "Shift solenoid valve at level 1: pressure over current, in steps up and down"
  extends Interfaces.SolenoidBench(redeclare model Valve = Valves.Levels.ShiftSolenoidL1);
  annotation(
    experiment(StopTime = 4.2, Tolerance = 1e-6, Interval = 1e-3),
    Documentation(info = "<html>
<p>4 states.</p>
</html>"));
end ShiftSolenoidL1;
