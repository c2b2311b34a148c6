within Mechanics.Rotational.Sources;
model Position "Prescribed angle, constant or rising smoothly"
  extends Interfaces.PartialOneFlange;
  parameter Units.Angle phi_start = 0 "Angle before the ramp";
  parameter Units.Angle phi_end = phi_start "Angle after the ramp";
  parameter Units.Time startTime = 0 "Start of the ramp";
  parameter Units.Time duration(min = 1e-9) = 1 "Duration of the ramp";
equation
  // Smooth ramp
  flange.phi = phi_start + (phi_end - phi_start)*Functions.smoothStep((time - startTime)/duration);
  annotation(Documentation(info = "<html>
<p>phi = phi_start + (phi_end - phi_start) smoothStep((t - startTime) / duration): twice continuously
differentiable, as an attached inertia requires.</p>
</html>"));
end Position;
