within TenSpeed.Benches;
model TorqueConverterL4 "Sweep of the speed ratio of the converter at level 4"
  extends Interfaces.ConverterBench(
    redeclare model Torus = Converter.TorusL4,
    redeclare Converter.SpeedSource impellerSource(w_start = 200),
    redeclare Converter.SpeedSource turbineSource(
      w_start = 0,
      w_end = 240,
      startTime = 10,
      duration = 4000));
  annotation(
    experiment(StopTime = 4020, Tolerance = 1e-6, Interval = 2),
    Documentation(info = "<html>
<p>No state.</p>
</html>"));
end TorqueConverterL4;
