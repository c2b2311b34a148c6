within TenSpeed.Benches;
model LubricationRegulatorL1 "Lubrication regulator at level 1: pressure over the flow of the supply"
  extends Interfaces.ReliefRegulatorBench(redeclare model Valve = Valves.Levels.LubricationRegulatorL1, d_load = 2e-3);
  annotation(
    experiment(StopTime = 3, Tolerance = 1e-6, Interval = 1e-3),
    Documentation(info = "<html>
<p>4 states.</p>
</html>"));
end LubricationRegulatorL1;
