within TenSpeed.Benches;
model LockupControlL5 "Lock-up control valve at level 5: clutch pressure over command, in steps up and down"
  extends Interfaces.LockupBench(redeclare model Valve = Valves.Levels.LockupControlL5);
  annotation(
    experiment(StopTime = 4.2, Tolerance = 1e-6, Interval = 1e-3),
    Documentation(info = "<html>
<p>No state.</p>
</html>"));
end LockupControlL5;
