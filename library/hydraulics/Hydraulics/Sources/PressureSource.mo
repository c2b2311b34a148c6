within Hydraulics.Sources;
model PressureSource "Prescribed pressure, constant or rising smoothly"
  extends Interfaces.PartialSource;
  parameter Units.AbsolutePressure p_start "Pressure before the ramp";
  parameter Units.AbsolutePressure p_end = p_start "Pressure after the ramp";
  parameter Mechanics.Units.Time startTime = 0 "Start of the ramp";
  parameter Mechanics.Units.Time duration(min = 1e-9) = 1 "Duration of the ramp";
equation
  // Smooth ramp
  port.p = p_start + (p_end - p_start)*Mechanics.Functions.smoothStep((time - startTime)/duration);
  annotation(Documentation(info = "<html>
<p>p = p_start + (p_end - p_start) smoothStep((t - startTime) / duration), whatever the flow: twice continuously
differentiable, so that a volume may be connected without a restriction between.</p>
</html>"));
end PressureSource;
