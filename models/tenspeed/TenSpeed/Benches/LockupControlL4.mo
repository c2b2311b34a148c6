within TenSpeed.Benches;
model LockupControlL4 "Lock-up control valve at level 4: clutch pressure over command, in steps up and down"
  extends Interfaces.LockupBench(redeclare model Valve = Valves.Levels.LockupControlL4);
  annotation(
    experiment(StopTime = 4.2, Tolerance = 1e-6, Interval = 1e-3),
    Documentation(info = "<html>
<p>2 states.</p>
</html>"));
end LockupControlL4;
