within TenSpeed.Benches;
model ConverterRegulatorL3 "Converter regulator at level 3: pressure over the flow of the supply"
  extends Interfaces.ReliefRegulatorBench(
    redeclare model Valve = Valves.Levels.ConverterRegulatorL3,
    d_load = 1.5e-3,
    p_drain = 3e5);
  annotation(
    experiment(StopTime = 3, Tolerance = 1e-6, Interval = 1e-3),
    Documentation(info = "<html>
<p>4 states.</p>
</html>"));
end ConverterRegulatorL3;
