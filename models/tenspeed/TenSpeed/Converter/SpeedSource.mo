within TenSpeed.Converter;
model SpeedSource "Prescribed speed, constant or rising smoothly"
  extends PartialDrive;
  parameter Mechanics.Units.AngularVelocity w_start "Speed before the ramp";
  parameter Mechanics.Units.AngularVelocity w_end = w_start "Speed after the ramp";
  parameter Mechanics.Units.Time startTime = 0 "Start of the ramp";
  parameter Mechanics.Units.Time duration(min = 1e-9) = 1 "Duration of the ramp";
equation
  shaft.w = w_start + (w_end - w_start)*Mechanics.Functions.smoothStep((time - startTime)/duration);
  annotation(Documentation(info = "<html>
<p>w = w_start + (w_end - w_start) smoothStep((t - startTime) / duration), whatever the torque.</p>
</html>"));
end SpeedSource;
