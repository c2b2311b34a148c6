within TenSpeed.Benches;
model MainRegulatorFlowL5 "Main regulator at level 5: line pressure over the flow of the supply"
  extends Interfaces.MainRegulatorBench(redeclare model Valve = Valves.Levels.MainRegulatorL5);
  annotation(
    experiment(StopTime = 3.5, Tolerance = 1e-6, Interval = 1e-3),
    Documentation(info = "<html>
<p>No state.</p>
</html>"));
end MainRegulatorFlowL5;
