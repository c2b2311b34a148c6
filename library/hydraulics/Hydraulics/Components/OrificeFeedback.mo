within Hydraulics.Components;
model OrificeFeedback "Pressure acts on a land of a spool behind an orifice"
  extends Interfaces.PartialFeedback;
  replaceable model Chamber = SpoolChamber constrainedby Interfaces.PartialSpoolChamber
    "Whether the spool displaces oil" annotation(choicesAllMatching = true);
  Chamber chamber(
    final fluid = fluid,
    final p_start = p_start,
    final pushes = pushes,
    final A = A,
    final V_0 = V_0) "Chamber at the land";
  Orifice orifice(final fluid = fluid, final d = d_orifice) "In front of the chamber";
equation
  connect(port, orifice.port_a);
  connect(orifice.port_b, chamber.port);
  connect(chamber.flange, flange);
  m = chamber.m;
  annotation(Documentation(info = "<html>
<p>One state, the pressure in the chamber.</p>
</html>"));
end OrificeFeedback;
