within Mechanics.Rotational.Sources;
model PositionSignal "Angle prescribed by a signal"
  extends Interfaces.PartialOneFlange;
  Signals.Interfaces.RealInput phi(unit = "rad") "Angle";
equation
  flange.phi = phi;
  annotation(Documentation(info = "<html>
<p>The shaft has the angle of the signal, which must be differentiable as often as what is attached requires: twice for
an inertia.</p>
</html>"));
end PositionSignal;
