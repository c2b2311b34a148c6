within Hydraulics.Interfaces;
partial model PartialRestriction "Flow between two ports without storage"
  replaceable package Oil = Media.OilDexronVI constrainedby Media.PartialOil "Oil whose data are the default"
    annotation(choicesAllMatching = true);
  parameter Media.Fluid fluid = Oil.data "Oil";
  Port port_a "Port on the left";
  Port port_b "Port on the right";
  Units.PressureDifference dp(start = 0) "Pressure difference from port_a to port_b";
  Units.Density rho "Density at the mean pressure";
  Units.MassFlowRate m_flow(start = 0) "Mass flow from port_a to port_b";
equation
  // Pressure difference
  dp = port_a.p - port_b.p;
  rho = Media.density((port_a.p + port_b.p)/2, fluid);
  // Conservation of mass, with the density of each port
  port_a.q = m_flow/Media.density(port_a.p, fluid);
  port_b.q = -m_flow/Media.density(port_b.p, fluid);
  annotation(Documentation(info = "<html>
<p>rho_a q_a = m_flow = -rho_b q_b. The extending model gives the law m_flow(dp, rho).</p>
</html>"));
end PartialRestriction;
