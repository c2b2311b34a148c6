within Hydraulics.Interfaces;
partial model PartialSpoolChamber "Oil in front of a spool, its pressure pushes the spool"
  extends PartialVolume;
  parameter Types.Direction pushes = Types.Direction.Positive "Direction in which the pressure pushes the spool";
  parameter Units.Area A "Area of the spool in the chamber";
  parameter Units.Volume V_0 "Volume at position 0";
  parameter Units.AbsolutePressure p_behind = Constants.p_atmosphere "Pressure on the other side of the area";
  Port port "Port";
  Mechanics.Translational.Interfaces.Flange flange "Spool";
protected
  final parameter Real orientation(final unit = "1") = if pushes == Types.Direction.Positive then 1 else -1
    "Sign of the motion that enlarges the chamber";
equation
  // Flow through the port
  port.p = p;
  m_flow = rho*port.q;
  // Force of the pressure on the spool
  flange.f = -orientation*A*(p - p_behind);
  annotation(Documentation(info = "<html>
<p>The spool receives &plusmn; A (p - p_behind). The extending model says whether its motion displaces oil.</p>
</html>"));
end PartialSpoolChamber;
