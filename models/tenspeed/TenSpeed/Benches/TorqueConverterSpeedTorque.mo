within TenSpeed.Benches;
model TorqueConverterSpeedTorque "Sweep of the speed ratio with the impeller's speed and the turbine's torque prescribed"
  extends Interfaces.ConverterBench(
    redeclare Converter.SpeedSource impellerSource(w_start = 200),
    redeclare Converter.TorqueSource turbineSource(
      tau_start = -297,
      tau_end = -20,
      startTime = 10,
      duration = 4000));
  annotation(
    experiment(StopTime = 4020, Tolerance = 1e-6, Interval = 2),
    Documentation(info = "<html>
<p>Level 1 by default: three states, w_t, w_s and Q. The load falls from that of a stalled turbine to 20 N.m.</p>
</html>"));
end TorqueConverterSpeedTorque;
