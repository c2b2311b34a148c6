within Hydraulics.Components;
model DirectFeedback "Pressure acts on a land of a spool without an orifice"
  extends Interfaces.PartialFeedback;
  replaceable model Chamber = SpoolChamber constrainedby Interfaces.PartialSpoolChamber
    "Whether the spool displaces oil" annotation(choicesAllMatching = true);
  Chamber chamber(
    final fluid = fluid,
    final p_start = p_start,
    final pushes = pushes,
    final A = A,
    final V_0 = V_0) "Chamber at the land";
equation
  connect(port, chamber.port);
  connect(chamber.flange, flange);
  m = chamber.m;
  annotation(Documentation(info = "<html>
<p>No state: the chamber is one volume with what it is connected to. The compiler finds that by itself, from the equal
pressures.</p>
</html>"));
end DirectFeedback;
