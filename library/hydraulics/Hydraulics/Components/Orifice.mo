within Hydraulics.Components;
model Orifice "Circular orifice with transition from laminar to turbulent flow"
  extends Interfaces.PartialRestriction;
  parameter Units.Diameter d "Diameter";
  parameter Units.Coefficient C_d = 0.7 "Discharge coefficient; chosen: a short, slightly rounded bore";
  parameter Units.Coefficient Re_crit = 100
    "Reynolds number of the transition; chosen: between 10 for a sharp edge and 1000 for a short tube";
  final parameter Units.Area A = Constants.pi*d^2/4 "Flow area";
equation
  // Orifice equation, laminar at small pressure difference
  m_flow = Functions.restrictionMassFlow(dp, A, d, C_d, Re_crit, rho, fluid.nu);
  annotation(Documentation(info = "<html>
<p>m_flow = C_d A sqrt(2 rho) dp / (dp<sup>2</sup> + dp_crit<sup>2</sup>)<sup>1/4</sup> with A = pi d<sup>2</sup> / 4
and dp_crit from Re_crit; see <code>Functions.restrictionMassFlow</code>.</p>
</html>"));
end Orifice;
