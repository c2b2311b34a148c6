within TenSpeed.Benches;
model MainRegulatorFlowL4 "Main regulator at level 4: line pressure over the flow of the supply"
  extends Interfaces.MainRegulatorBench(redeclare model Valve = Valves.Levels.MainRegulatorL4);
  annotation(
    experiment(StopTime = 3.5, Tolerance = 1e-6, Interval = 1e-3),
    Documentation(info = "<html>
<p>4 states.</p>
</html>"));
end MainRegulatorFlowL4;
