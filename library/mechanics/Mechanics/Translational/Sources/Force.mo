within Mechanics.Translational.Sources;
model Force "Force from the case on a rod, constant or rising smoothly"
  extends Interfaces.PartialOneFlange;
  parameter Units.Force f_start "Force before the ramp, positive pushes forward";
  parameter Units.Force f_end = f_start "Force after the ramp";
  parameter Units.Time startTime = 0 "Start of the ramp";
  parameter Units.Time duration(min = 1e-9) = 1 "Duration of the ramp";
  Units.Force f "Driving force";
equation
  // Smooth ramp
  f = f_start + (f_end - f_start)*Functions.smoothStep((time - startTime)/duration);
  // The rod receives what the source gives
  flange.f = -f;
  annotation(Documentation(info = "<html>
<p>f = f_start + (f_end - f_start) smoothStep((t - startTime) / duration).</p>
</html>"));
end Force;
