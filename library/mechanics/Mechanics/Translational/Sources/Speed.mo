within Mechanics.Translational.Sources;
model Speed "Prescribed speed, constant or rising smoothly, given as a position"
  extends Interfaces.PartialOneFlange;
  parameter Units.Velocity v_start "Speed before the ramp";
  parameter Units.Velocity v_end = v_start "Speed after the ramp";
  parameter Units.Time startTime = 0 "Start of the ramp";
  parameter Units.Time duration(min = 1e-9) = 1 "Duration of the ramp";
  parameter Units.Position s_0 = 0 "Position at time 0 of a ramp that has not begun";
equation
  // Integral of the smooth ramp of speed
  flange.s = s_0 + v_start*time
    + (v_end - v_start)*duration*Functions.smoothStepIntegral((time - startTime)/duration);
  annotation(Documentation(info = "<html>
<p>s = s_0 + v_start t + (v_end - v_start) duration smoothStepIntegral((t - startTime) / duration), in closed form: no
state.</p>
</html>"));
end Speed;
