within TenSpeed.Converter;
model TorqueSource "Prescribed torque on the shaft, constant or rising smoothly"
  extends PartialDrive;
  parameter Mechanics.Units.Torque tau_start "Torque on the shaft before the ramp";
  parameter Mechanics.Units.Torque tau_end = tau_start "Torque on the shaft after the ramp";
  parameter Mechanics.Units.Time startTime = 0 "Start of the ramp";
  parameter Mechanics.Units.Time duration(min = 1e-9) = 1 "Duration of the ramp";
equation
  shaft.tau = -tau_start - (tau_end - tau_start)*Mechanics.Functions.smoothStep((time - startTime)/duration);
  annotation(Documentation(info = "<html>
<p>tau = tau_start + (tau_end - tau_start) smoothStep((t - startTime) / duration) on the shaft, whatever the speed.</p>
</html>"));
end TorqueSource;
