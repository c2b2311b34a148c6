within Hydraulics.Components;
model LaminarOrifice "Long thin passage with laminar flow"
  extends Interfaces.PartialRestriction;
  parameter Units.Diameter d "Diameter";
  parameter Mechanics.Units.Length l(min = 0) "Length";
equation
  // Hagen and Poiseuille's law, dynamic viscosity rho nu
  m_flow = Constants.pi*d^4/(128*fluid.nu*l)*dp;
  annotation(Documentation(info = "<html>
<p>q = pi d<sup>4</sup> dp / (128 rho nu l), hence m_flow = pi d<sup>4</sup> dp / (128 nu l). Valid for a Reynolds
number below about 2000 and l much larger than d.</p>
</html>"));
end LaminarOrifice;
