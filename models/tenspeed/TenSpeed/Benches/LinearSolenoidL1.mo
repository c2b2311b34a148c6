within TenSpeed.Benches;
model LinearSolenoidL1 "Linear solenoid valve at level 1: pressure over current, in steps up and down"
  extends Interfaces.SolenoidBench(redeclare model Valve = Valves.Levels.LinearSolenoidL1);
  annotation(
    experiment(StopTime = 4.2, Tolerance = 1e-6, Interval = 1e-3),
    Documentation(info = "<html>
<p>5 states.</p>
</html>"));
end LinearSolenoidL1;
