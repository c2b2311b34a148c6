within Hydraulics.Sources;
model FilteredPressureStep "Step of pressure behind a filter of second order"
  extends Interfaces.PartialSource;
  parameter Units.AbsolutePressure p_start "Pressure before the step";
  parameter Units.AbsolutePressure p_end "Pressure long after it";
  parameter Mechanics.Units.Time startTime = 0 "Time of the step";
  parameter Mechanics.Units.Time T(min = 1e-9) "Time constant";
protected
  Real u(unit = "1") "Time since the step over the time constant";
equation
  // Response of 1/(1 + T s)^2 in closed form
  u = smooth(0, noEvent(max(0, (time - startTime)/T)));
  port.p = p_end + (p_start - p_end)*(1 + u)*exp(-u);
  annotation(Documentation(info = "<html>
<p>p = p_end + (p_start - p_end) (1 + u) exp(-u), u = (t - startTime) / T: a step behind two lags of first order, written
in closed form so that the source has no state. Once continuously differentiable.</p>
</html>"));
end FilteredPressureStep;
