within Hydraulics.Components;
model SpoolChamber "Oil in front of a spool: its pressure pushes the spool, the spool's motion displaces it"
  extends Interfaces.PartialVolume;
  parameter Types.Direction pushes = Types.Direction.Positive "Direction in which the pressure pushes the spool";
  parameter Units.Area A "Area of the spool in the chamber";
  parameter Units.Volume V_0 "Volume at position 0";
  parameter Units.AbsolutePressure p_behind = Constants.p_atmosphere "Pressure on the other side of the area";
  Interfaces.Port port "Port";
  Mechanics.Translational.Interfaces.Flange flange "Spool";
protected
  final parameter Real orientation(final unit = "1") = if pushes == Types.Direction.Positive then 1 else -1
    "Sign of the motion that enlarges the chamber";
equation
  // Displacement by the spool
  V = V_0 + orientation*A*flange.s;
  V_flow = orientation*A*der(flange.s);
  // Flow through the port
  port.p = p;
  m_flow = rho*port.q;
  // Force of the pressure on the spool
  flange.f = -orientation*A*(p - p_behind);
  annotation(Documentation(info = "<html>
<p>d(rho V)/dt = rho q with V = V_0 &plusmn; A s; the spool receives &plusmn; A (p - p_behind). The work A p ds
taken from the oil is the work given to the spool.</p>
</html>"));
end SpoolChamber;
