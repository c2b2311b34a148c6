within Mechanics.Rotational.Sources;
model Speed "Prescribed speed, constant or rising smoothly, given as an angle"
  extends Interfaces.PartialOneFlange;
  parameter Units.AngularVelocity w_start "Speed before the ramp";
  parameter Units.AngularVelocity w_end = w_start "Speed after the ramp";
  parameter Units.Time startTime = 0 "Start of the ramp";
  parameter Units.Time duration(min = 1e-9) = 1 "Duration of the ramp";
  parameter Units.Angle phi_0 = 0 "Angle at time 0 of a ramp that has not begun";
equation
  // Integral of the smooth ramp of speed
  flange.phi = phi_0 + w_start*time
    + (w_end - w_start)*duration*Functions.smoothStepIntegral((time - startTime)/duration);
  annotation(Documentation(info = "<html>
<p>phi = phi_0 + w_start t + (w_end - w_start) duration smoothStepIntegral((t - startTime) / duration). Its
derivative is w_start + (w_end - w_start) smoothStep((t - startTime) / duration). The integral is written in closed
form, so the source has no state.</p>
</html>"));
end Speed;
