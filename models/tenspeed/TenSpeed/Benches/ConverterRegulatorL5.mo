within TenSpeed.Benches;
model ConverterRegulatorL5 "Converter regulator at level 5: pressure over the flow of the supply"
  extends Interfaces.ReliefRegulatorBench(
    redeclare model Valve = Valves.Levels.ConverterRegulatorL5,
    d_load = 1.5e-3,
    p_drain = 3e5);
  annotation(
    experiment(StopTime = 3, Tolerance = 1e-6, Interval = 1e-3),
    Documentation(info = "<html>
<p>No state.</p>
</html>"));
end ConverterRegulatorL5;
