within Signals.Examples;
model StepsOfASignal "Signal that rises, falls half-way and rests"
  Sources.SmoothSteps steps(times = {1, 3}, values = {0, 2, 1}) "Signal";
  Sources.SmoothSchedule schedule(times = {1, 3}, values = {{0, 2, 1}, {1, 1, 4}}) "Two signals, the first as above";
  Sources.Constant offset(k = 0.5) "Constant signal";
  output Real error "Difference to the closed form where the signal rests";
  output Real other = schedule.y[2] "The second signal of the schedule";
equation
  // Closed form away from the ramps
  error = noEvent(abs(schedule.y[1] - steps.y)) + noEvent(
    if time < 1 then steps.y
    elseif time > 1.5 and time < 3 then steps.y - 2
    elseif time > 3.5 then steps.y - 2*offset.y
    else 0);
  annotation(
    experiment(StopTime = 5, Tolerance = 1e-6),
    Documentation(info = "<html>
<p>0, then 2 from 1.5 s, then 1 from 3.5 s.</p>
</html>"));
end StepsOfASignal;
