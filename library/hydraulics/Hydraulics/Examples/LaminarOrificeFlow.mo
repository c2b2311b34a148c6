within Hydraulics.Examples;
model LaminarOrificeFlow "Capillary under a pressure difference that changes sign"
  Sources.PressureSource left(p_start = 1e5, p_end = 3e5, startTime = 0, duration = 1) "Rising pressure";
  Components.LaminarOrifice capillary(d = 1e-3, l = 0.1) "Restriction";
  Sources.Tank right(p_tank = 2e5) "Constant pressure";
  output Units.MassFlowRate error "Mass lost between the ports";
equation
  connect(left.port, capillary.port_a);
  connect(capillary.port_b, right.port);
  // Conservation of mass across the restriction
  error = Media.density(capillary.port_a.p, capillary.fluid)*capillary.port_a.q
    + Media.density(capillary.port_b.p, capillary.fluid)*capillary.port_b.q;
  annotation(
    experiment(StopTime = 1, Tolerance = 1e-6),
    Documentation(info = "<html>
<p>m_flow = pi d<sup>4</sup> dp / (128 nu l); the volume flows of the two ports differ as the densities do.</p>
</html>"));
end LaminarOrificeFlow;
