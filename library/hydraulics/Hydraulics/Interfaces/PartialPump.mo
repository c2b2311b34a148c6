within Hydraulics.Interfaces;
partial model PartialPump "Displacement machine between two ports and a shaft"
  replaceable package Oil = Media.OilDexronVI constrainedby Media.PartialOil "Oil whose data are the default"
    annotation(choicesAllMatching = true);
  parameter Media.Fluid fluid = Oil.data "Oil";
  parameter Units.Volume D "Displacement per revolution";
  parameter Real leakage(unit = "m3/(s.Pa)", min = 0) = 0 "Internal leakage per pressure difference";
  parameter Mechanics.Units.RotationalDampingConstant d(min = 0) = 0 "Viscous friction of the shaft";
  Port port_a "Inlet";
  Port port_b "Outlet";
  Mechanics.Rotational.Interfaces.Flange flange "Shaft; driven forward it pumps from port_a to port_b";
  Units.Volume displacement "Present displacement per revolution";
  Mechanics.Units.AngularVelocity w "Speed of the shaft";
  Units.PressureDifference dp "Pressure of the outlet over that of the inlet";
  Units.VolumeFlowRate q "Flow at the density of the inlet";
  Units.MassFlowRate m_flow "Mass flow from inlet to outlet";
equation
  w = der(flange.phi);
  dp = port_b.p - port_a.p;
  // Displacement at the inlet's density, less what leaks back
  q = displacement*w/(2*Constants.pi) - leakage*dp;
  m_flow = Media.density(port_a.p, fluid)*q;
  // Conservation of mass, with the density of each port
  port_a.q = q;
  Media.density(port_b.p, fluid)*port_b.q = -m_flow;
  // Torque of the pressure and of friction
  flange.tau = displacement*dp/(2*Constants.pi) + d*w;
  annotation(Documentation(info = "<html>
<p>q = D w / 2pi - leakage dp, tau = D dp / 2pi + d w. Without leakage and friction the power tau w of the shaft is the
hydraulic power q dp. The extending model gives the displacement.</p>
</html>"));
end PartialPump;
