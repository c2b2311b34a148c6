within Hydraulics.Functions;
function restrictionMassFlow "Mass flow through a restriction, laminar or turbulent by pressure difference"
  input Units.PressureDifference dp "Pressure difference";
  input Units.Area A "Flow area";
  input Units.Diameter d_h "Hydraulic diameter";
  input Units.Coefficient C_d "Discharge coefficient in turbulent flow";
  input Units.Coefficient Re_crit "Reynolds number of the transition";
  input Units.Density rho "Density in the restriction";
  input Units.KinematicViscosity nu "Kinematic viscosity";
  output Units.MassFlowRate m_flow "Mass flow in the direction of falling pressure";
protected
  Units.PressureDifference dp_crit "Pressure difference of the transition";
algorithm
  dp_crit := rho/2*(Re_crit*nu/(C_d*d_h))^2;
  m_flow := C_d*A*sqrt(2*rho)*dp/(dp^2 + dp_crit^2)^0.25;
  annotation(
    Inline = true,
    smoothOrder = 10,
    Documentation(info = "<html>
<p>m_flow = C_d A sqrt(2 rho) dp / (dp<sup>2</sup> + dp_crit<sup>2</sup>)<sup>1/4</sup>.</p>
<p>For |dp| much larger than dp_crit this is the orifice equation C_d A sqrt(2 rho dp) (H. E. Merritt, Hydraulic
Control Systems, 1967, section 3-4); for small dp it is proportional to dp. dp_crit is the pressure difference at which
the velocity C_d sqrt(2 dp / rho) reaches the Reynolds number Re_crit = v d_h / nu:
dp_crit = rho / 2 (Re_crit nu / (C_d d_h))<sup>2</sup>. The slope at dp = 0 is finite and flow in both directions
follows the same curve.</p>
</html>"));
end restrictionMassFlow;
