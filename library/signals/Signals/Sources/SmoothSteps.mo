within Signals.Sources;
block SmoothSteps "Piecewise constant signal whose steps are smooth ramps"
  parameter Real times[:](each unit = "s") "Start of each ramp, rising";
  parameter Real values[:] "Values: the first before any ramp, then after each";
  parameter Real duration(unit = "s", min = 1e-9) = 0.5 "Duration of a ramp";
  Interfaces.RealOutput y "Signal";
protected
  Boolean begun[size(times, 1)] = {time >= times[j] for j in 1:size(times, 1)} "Ramps that have begun; events";
equation
  assert(size(values, 1) == size(times, 1) + 1, "values needs one entry more than times");
  y = values[1] + sum({
    (values[j + 1] - values[j])*Mechanics.Functions.smoothStep((time - times[j])/duration) for j in 1:size(times, 1)});
  annotation(Documentation(info = "<html>
<p>y = values[1] + &sum; (values[j+1] - values[j]) smoothStep((t - times[j]) / duration): twice continuously
differentiable. Ramps may overlap. The start of each is an event, so that no solver steps over a pulse.</p>
</html>"));
end SmoothSteps;
