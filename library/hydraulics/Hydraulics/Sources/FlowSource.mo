within Hydraulics.Sources;
model FlowSource "Prescribed volume flow, constant or rising smoothly"
  extends Interfaces.PartialSource;
  parameter Units.VolumeFlowRate q_start "Flow out of the source before the ramp";
  parameter Units.VolumeFlowRate q_end = q_start "Flow out of the source after the ramp";
  parameter Mechanics.Units.Time startTime = 0 "Start of the ramp";
  parameter Mechanics.Units.Time duration(min = 1e-9) = 1 "Duration of the ramp";
  Units.VolumeFlowRate q "Flow out of the source at the density of the port's pressure";
equation
  // Smooth ramp
  q = q_start + (q_end - q_start)*Mechanics.Functions.smoothStep((time - startTime)/duration);
  // What leaves the source enters the circuit
  port.q = -q;
  annotation(Documentation(info = "<html>
<p>q = q_start + (q_end - q_start) smoothStep((t - startTime) / duration), whatever the pressure.</p>
</html>"));
end FlowSource;
