within Hydraulics.Components;
model VariablePump "Pump whose displacement follows a signal"
  extends Interfaces.PartialPump;
  Signals.Interfaces.RealInput setting "Displacement over D, from -1 to 1";
equation
  displacement = D*smooth(0, noEvent(max(-1, min(1, setting))));
  annotation(Documentation(info = "<html>
<p>Displacement D times the signal, clipped to -1 and 1: a swash plate passes through zero and reverses the flow.</p>
</html>"));
end VariablePump;
