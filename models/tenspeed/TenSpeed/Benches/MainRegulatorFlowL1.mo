within TenSpeed.Benches;
model MainRegulatorFlowL1 "Main regulator at level 1: line pressure over the flow of the supply"
  extends Interfaces.MainRegulatorBench(redeclare model Valve = Valves.Levels.MainRegulatorL1);
  annotation(
    experiment(StopTime = 3.5, Tolerance = 1e-6, Interval = 1e-3),
    Documentation(info = "<html>
<p>5 states.</p>
</html>"));
end MainRegulatorFlowL1;
