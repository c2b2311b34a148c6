within TenSpeed.Benches;
model TorqueConverterTorqueSpeed "Sweep of the speed ratio with the impeller's torque and the turbine's speed prescribed"
  extends Interfaces.ConverterBench(
    redeclare Converter.TorqueSource impellerSource(tau_start = 140),
    redeclare Converter.SpeedSource turbineSource(
      w_start = 0,
      w_end = 300,
      startTime = 10,
      duration = 4000));
  annotation(
    experiment(StopTime = 4020, Tolerance = 1e-6, Interval = 2),
    Documentation(info = "<html>
<p>Level 1 by default: three states, w_p, w_s and Q. The impeller speeds up with the turbine.</p>
</html>"));
end TorqueConverterTorqueSpeed;
