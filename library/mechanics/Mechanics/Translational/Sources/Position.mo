within Mechanics.Translational.Sources;
model Position "Prescribed position, constant or rising smoothly"
  extends Interfaces.PartialOneFlange;
  parameter Units.Position s_start = 0 "Position before the ramp";
  parameter Units.Position s_end = s_start "Position after the ramp";
  parameter Units.Time startTime = 0 "Start of the ramp";
  parameter Units.Time duration(min = 1e-9) = 1 "Duration of the ramp";
equation
  // Smooth ramp
  flange.s = s_start + (s_end - s_start)*Functions.smoothStep((time - startTime)/duration);
  annotation(Documentation(info = "<html>
<p>s = s_start + (s_end - s_start) smoothStep((t - startTime) / duration): twice continuously differentiable, as an
attached mass requires.</p>
</html>"));
end Position;
