within TenSpeed.Interfaces;
partial model PartialThreeWay "Valve with supply, outlet and drain, and its balance of mass"
  replaceable package Oil = Hydraulics.Media.OilDexronVI constrainedby Hydraulics.Media.PartialOil
    "Oil whose data are the default" annotation(choicesAllMatching = true);
  parameter Hydraulics.Media.Fluid fluid = Oil.data "Oil";
  parameter Hydraulics.Units.AbsolutePressure p_start = 101325 "Proposed initial pressures";
  Hydraulics.Interfaces.Port supply "Supply";
  Hydraulics.Interfaces.Port drain "Drain";
  Hydraulics.Interfaces.Port outlet "Outlet";
  Mechanics.Units.Position s "Position of the spool, 0 where there is none";
  Mechanics.Units.Mass m_oil "Mass of oil and air inside";
  Hydraulics.Units.MassFlowRate m_supply "Mass flow in from the supply";
  Hydraulics.Units.MassFlowRate m_drain "Mass flow out to the drain";
  Hydraulics.Units.MassFlowRate m_outlet "Mass flow out of the outlet";
equation
  // Mass flows at the ports
  m_supply = Hydraulics.Media.density(supply.p, fluid)*supply.q;
  m_drain = -Hydraulics.Media.density(drain.p, fluid)*drain.q;
  m_outlet = -Hydraulics.Media.density(outlet.p, fluid)*outlet.q;
  annotation(Documentation(info = "<html>
<p>d m_oil/dt = m_supply - m_drain - m_outlet at every level.</p>
</html>"));
end PartialThreeWay;
