within Hydraulics.Components;
model CheckValve "Check valve: its area opens with the pressure difference, from port_a to port_b only"
  extends Interfaces.PartialRestriction;
  parameter Units.Diameter d "Diameter of the flow area when fully open";
  parameter Units.PressureDifference dp_open = 0.2e5 "Pressure difference at which it begins to open; chosen: soft spring";
  parameter Units.PressureDifference dp_full(min = 1) = 0.7e5 "Pressure difference at which it is fully open";
  parameter Units.Fraction leakage(min = 1e-9) = 1e-6 "Area of the closed valve over the full area; chosen: a few drops";
  parameter Units.Coefficient C_d = 0.7 "Discharge coefficient; chosen: as Orifice";
  parameter Units.Coefficient Re_crit = 100 "Reynolds number of the transition; chosen: as Orifice";
  Units.Area A "Flow area";
equation
  // The ball rises with the pressure difference
  A = Constants.pi*d^2/4*(leakage + (1 - leakage)*Mechanics.Functions.smoothStep((dp - dp_open)/(dp_full - dp_open)));
  m_flow = Functions.restrictionMassFlow(dp, A, d, C_d, Re_crit, rho, fluid.nu);
  annotation(Documentation(info = "<html>
<p>Orifice equation with the area pi d<sup>2</sup>/4 smoothStep((dp - dp_open) / (dp_full - dp_open)), and a leakage when
shut. The ball has no mass: no state, no event.</p>
</html>"));
end CheckValve;
