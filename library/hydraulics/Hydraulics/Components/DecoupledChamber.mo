within Hydraulics.Components;
model DecoupledChamber "Oil in front of a spool: its pressure pushes the spool, whose motion displaces nothing"
  extends Interfaces.PartialSpoolChamber;
equation
  // The chamber keeps its volume
  V = V_0;
  V_flow = 0;
  annotation(Documentation(info = "<html>
<p>d(rho V_0)/dt = rho q; the spool receives &plusmn; A (p - p_behind). For spools whose displacement is small against
the flow through the chamber's orifice.</p>
</html>"));
end DecoupledChamber;
