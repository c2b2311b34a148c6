within Mechanics.Translational.Sources;
model ForceSignal "Force from the case on a body, given by a signal"
  extends Interfaces.PartialOneFlange;
  Signals.Interfaces.RealInput f(unit = "N") "Force, positive pushes forward";
equation
  flange.f = -f;
  annotation(Documentation(info = "<html>
<p>The body receives the force of the signal.</p>
</html>"));
end ForceSignal;
