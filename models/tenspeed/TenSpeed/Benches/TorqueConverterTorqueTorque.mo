within TenSpeed.Benches;
model TorqueConverterTorqueTorque "Sweep of the torque ratio with both torques prescribed"
  extends Interfaces.ConverterBench(
    redeclare Converter.TorqueSource impellerSource(tau_start = 140),
    redeclare Converter.TorqueSource turbineSource(
      tau_start = -297,
      tau_end = -150,
      startTime = 10,
      duration = 4000));
  annotation(
    experiment(StopTime = 4020, Tolerance = 1e-6, Interval = 2),
    Documentation(info = "<html>
<p>Level 1 by default: all four states. The load falls from that of a stalled turbine to 1.07 times the impeller's torque.</p>
</html>"));
end TorqueConverterTorqueTorque;
