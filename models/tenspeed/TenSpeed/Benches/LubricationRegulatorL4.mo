within TenSpeed.Benches;
model LubricationRegulatorL4 "Lubrication regulator at level 4: pressure over the flow of the supply"
  extends Interfaces.ReliefRegulatorBench(redeclare model Valve = Valves.Levels.LubricationRegulatorL4, d_load = 2e-3);
  annotation(
    experiment(StopTime = 3, Tolerance = 1e-6, Interval = 1e-3),
    Documentation(info = "<html>
<p>2 states.</p>
</html>"));
end LubricationRegulatorL4;
