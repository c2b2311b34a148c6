within Hydraulics.Sources;
model SlippingPump "Prescribed volume flow, constant or rising smoothly, less what slips back"
  extends Interfaces.PartialSource(port(p(start = p_shutOff)));
  parameter Units.VolumeFlowRate q_start "Displaced flow before the ramp";
  parameter Units.VolumeFlowRate q_end = q_start "Displaced flow after the ramp";
  parameter Mechanics.Units.Time startTime = 0 "Start of the ramp";
  parameter Mechanics.Units.Time duration(min = 1e-9) = 1 "Duration of the ramp";
  parameter Units.AbsolutePressure p_inlet = Constants.p_atmosphere "Pressure at the inlet";
  parameter Units.AbsolutePressure p_shutOff "Pressure at which all of q_end slips back";
  final parameter Real slip(final unit = "m3/(s.Pa)") = q_end/(p_shutOff - p_inlet) "Slip per pressure difference";
  Units.VolumeFlowRate q "Flow out of the pump at the density of the port's pressure";
equation
  // Smooth ramp and laminar slip
  q = q_start + (q_end - q_start)*Mechanics.Functions.smoothStep((time - startTime)/duration)
    - slip*(port.p - p_inlet);
  // What leaves the pump enters the circuit
  port.q = -q;
  annotation(Documentation(info = "<html>
<p>q = q_start + (q_end - q_start) smoothStep((t - startTime) / duration) - slip (p - p_inlet): a flow source that a
closed circuit stops at p_shutOff.</p>
</html>"));
end SlippingPump;
