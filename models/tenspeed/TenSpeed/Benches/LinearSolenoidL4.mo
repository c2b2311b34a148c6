within TenSpeed.Benches;
model LinearSolenoidL4 "Linear solenoid valve at level 4: pressure over current, in steps up and down"
  extends Interfaces.SolenoidBench(redeclare model Valve = Valves.Levels.LinearSolenoidL4);
  annotation(
    experiment(StopTime = 4.2, Tolerance = 1e-6, Interval = 1e-3),
    Documentation(info = "<html>
<p>2 states.</p>
</html>"));
end LinearSolenoidL4;
