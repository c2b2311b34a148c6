within Mechanics.Rotational.Sources;
model Torque "Torque from the case on a shaft, constant or rising smoothly"
  extends Interfaces.PartialOneFlange;
  parameter Units.Torque tau_start "Torque before the ramp, positive drives the shaft forward";
  parameter Units.Torque tau_end = tau_start "Torque after the ramp";
  parameter Units.Time startTime = 0 "Start of the ramp";
  parameter Units.Time duration(min = 1e-9) = 1 "Duration of the ramp";
  Units.Torque tau "Driving torque";
equation
  // Smooth ramp
  tau = tau_start + (tau_end - tau_start)*Functions.smoothStep((time - startTime)/duration);
  // The shaft receives what the source gives
  flange.tau = -tau;
  annotation(Documentation(info = "<html>
<p>tau = tau_start + (tau_end - tau_start) smoothStep((t - startTime) / duration).</p>
</html>"));
end Torque;
