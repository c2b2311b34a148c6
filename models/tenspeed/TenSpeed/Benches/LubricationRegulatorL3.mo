within TenSpeed.Benches;
model LubricationRegulatorL3 "Lubrication regulator at level 3: pressure over the flow of the supply"
  extends Interfaces.ReliefRegulatorBench(redeclare model Valve = Valves.Levels.LubricationRegulatorL3, d_load = 2e-3);
  annotation(
    experiment(StopTime = 3, Tolerance = 1e-6, Interval = 1e-3),
    Documentation(info = "<html>
<p>3 states.</p>
</html>"));
end LubricationRegulatorL3;
