within Hydraulics.Sources;
model FilteredFlowStep "Step of volume flow behind a filter of second order"
  extends Interfaces.PartialSource;
  parameter Units.VolumeFlowRate q_start = 0 "Flow out of the source before the step";
  parameter Units.VolumeFlowRate q_end "Flow long after it";
  parameter Mechanics.Units.Time startTime = 0 "Time of the step";
  parameter Mechanics.Units.Time T(min = 1e-9) "Time constant";
  Units.VolumeFlowRate q "Flow out of the source";
protected
  Real u(unit = "1") "Time since the step over the time constant";
equation
  // Response of 1/(1 + T s)^2 in closed form
  u = smooth(0, noEvent(max(0, (time - startTime)/T)));
  q = q_end + (q_start - q_end)*(1 + u)*exp(-u);
  port.q = -q;
  annotation(Documentation(info = "<html>
<p>q = q_end + (q_start - q_end) (1 + u) exp(-u), u = (t - startTime) / T.</p>
</html>"));
end FilteredFlowStep;
