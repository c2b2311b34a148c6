within TenSpeed.Converter;
model Dynamometer "Electric brake that follows a speed with a stiff characteristic"
  extends PartialDrive;
  parameter Mechanics.Units.AngularVelocity w_start "Speed without load before the ramp";
  parameter Mechanics.Units.AngularVelocity w_end = w_start "Speed without load after the ramp";
  parameter Mechanics.Units.Time startTime = 0 "Start of the ramp";
  parameter Mechanics.Units.Time duration(min = 1e-9) = 1 "Duration of the ramp";
  parameter Mechanics.Units.RotationalDampingConstant k(min = 1e-9) = 1e3
    "Slope of the characteristic; chosen: 0.3 rad/s at the torque of a stalled converter";
  Mechanics.Units.AngularVelocity w_set "Speed without load";
equation
  w_set = w_start + (w_end - w_start)*Mechanics.Functions.smoothStep((time - startTime)/duration);
  // Characteristic
  shaft.tau = -k*(w_set - shaft.w);
  annotation(Documentation(info = "<html>
<p>Torque on the shaft k (w_set - w): neither speed nor torque is prescribed, so that the speed stays a state.</p>
</html>"));
end Dynamometer;
