within Signals.Sources;
block SmoothSchedule "Signals that change at the same times, in smooth ramps"
  parameter Real times[:](each unit = "s") "Start of each ramp, rising";
  parameter Real values[:, :] "A row for each signal: its value before any ramp, then after each";
  parameter Real duration(unit = "s", min = 1e-9) = 0.5 "Duration of a ramp";
  parameter Integer slack[size(times, 1)](each min = 1) = fill(1, size(times, 1))
    "In the middle of a ramp, rising and falling signals alike are at (1/2)^slack of their step";
  Interfaces.RealOutput y[size(values, 1)] "Signals";
protected
  Real progress[size(times, 1)](each unit = "1") "Progress of each ramp";
equation
  assert(size(values, 2) == size(times, 1) + 1, "a row of values needs one entry more than times");
  progress = {Mechanics.Functions.smoothStep((time - times[j])/duration) for j in 1:size(times, 1)};
  y = {values[k, 1] + sum({(values[k, j + 1] - values[k, j])*(
    if values[k, j + 1] > values[k, j] then progress[j]^slack[j] else 1 - (1 - progress[j])^slack[j])
    for j in 1:size(times, 1)}) for k in 1:size(values, 1)};
  annotation(Documentation(info = "<html>
<p>y[k] = values[k, 1] + &sum; (values[k, j+1] - values[k, j]) smoothStep((t - times[j]) / duration): as
<code>SmoothSteps</code> for every signal, with each ramp computed once. With slack above 1 both the rise of one signal and
the fall of another are smoothStep to the power of slack, forward and backward in time, above their lower value: where
one takes over from the other they overlap less.</p>
</html>"));
end SmoothSchedule;
