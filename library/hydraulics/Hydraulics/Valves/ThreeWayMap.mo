within Hydraulics.Valves;
model ThreeWayMap "Outlet pressure as a weighted mean of supply and drain"
  replaceable package Oil = Media.OilDexronVI constrainedby Media.PartialOil "Oil whose data are the default"
    annotation(choicesAllMatching = true);
  parameter Media.Fluid fluid = Oil.data "Oil";
  Interfaces.Port supply "Supply";
  Interfaces.Port drain "Drain";
  Interfaces.Port outlet "Outlet";
  Signals.Interfaces.RealInput w(unit = "1") "Weight of the supply, 0 to 1";
  Units.MassFlowRate m_flow "Mass flow out of the outlet";
equation
  // Pressure
  outlet.p = w*supply.p + (1 - w)*drain.p;
  // Conservation of mass, shared by the weight
  m_flow = -Media.density(outlet.p, fluid)*outlet.q;
  supply.q = w*m_flow/Media.density(supply.p, fluid);
  drain.q = (1 - w)*m_flow/Media.density(drain.p, fluid);
  annotation(Documentation(info = "<html>
<p>p_outlet = w p_supply + (1 - w) p_drain. What leaves the outlet comes from supply and drain in the ratio of the
weights, so mass is conserved and, but for the change of density, power too. No state and no restriction: it stands in
for the volumes on both sides.</p>
</html>"));
end ThreeWayMap;
