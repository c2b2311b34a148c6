within TenSpeed.Benches;
model LubricationRegulatorL5 "Lubrication regulator at level 5: pressure over the flow of the supply"
  extends Interfaces.ReliefRegulatorBench(redeclare model Valve = Valves.Levels.LubricationRegulatorL5, d_load = 2e-3);
  annotation(
    experiment(StopTime = 3, Tolerance = 1e-6, Interval = 1e-3),
    Documentation(info = "<html>
<p>No state.</p>
</html>"));
end LubricationRegulatorL5;
