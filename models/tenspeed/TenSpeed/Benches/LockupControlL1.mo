within TenSpeed.Benches;
model LockupControlL1 "Lock-up control valve at level 1: clutch pressure over command, in steps up and down"
  extends Interfaces.LockupBench(redeclare model Valve = Valves.Levels.LockupControlL1);
  annotation(
    experiment(StopTime = 4.2, Tolerance = 1e-6, Interval = 1e-3),
    Documentation(info = "<html>
<p>5 states.</p>
</html>"));
end LockupControlL1;
