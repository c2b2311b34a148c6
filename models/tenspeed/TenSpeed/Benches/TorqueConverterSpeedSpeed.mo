within TenSpeed.Benches;
model TorqueConverterSpeedSpeed "Sweep of the speed ratio with both speeds prescribed"
  extends Interfaces.ConverterBench(
    redeclare Converter.SpeedSource impellerSource(w_start = 200),
    redeclare Converter.SpeedSource turbineSource(
      w_start = 0,
      w_end = 240,
      startTime = 10,
      duration = 4000));
  annotation(
    experiment(StopTime = 4020, Tolerance = 1e-6, Interval = 2),
    Documentation(info = "<html>
<p>Level 1 by default: two states, w_s and Q.</p>
</html>"));
end TorqueConverterSpeedSpeed;
