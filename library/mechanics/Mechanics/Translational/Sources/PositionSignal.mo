within Mechanics.Translational.Sources;
model PositionSignal "Position prescribed by a signal"
  extends Interfaces.PartialOneFlange;
  Signals.Interfaces.RealInput s(unit = "m") "Position";
equation
  flange.s = s;
  annotation(Documentation(info = "<html>
<p>The rod has the position of the signal, which must be differentiable as often as what is attached requires: twice for
a mass.</p>
</html>"));
end PositionSignal;
