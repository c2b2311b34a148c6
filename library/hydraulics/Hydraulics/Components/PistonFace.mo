within Hydraulics.Components;
model PistonFace "Pressure acts on a land of a spool, no oil stands in front of it"
  extends Interfaces.PartialFeedback;
  parameter Units.AbsolutePressure p_behind = Constants.p_atmosphere "Pressure on the other side of the area";
protected
  final parameter Real orientation(final unit = "1") = if pushes == Types.Direction.Positive then 1 else -1
    "Direction of the force";
equation
  // Force of the pressure on the spool, at once
  flange.f = -orientation*A*(port.p - p_behind);
  // Nothing is stored and nothing displaced
  port.q = 0;
  m = 0;
  annotation(Documentation(info = "<html>
<p>The spool receives &plusmn; A (p - p_behind); no flow, no state.</p>
</html>"));
end PistonFace;
