within Hydraulics.Components;
model PressureRelief "Relief valve without mass: its area opens with the pressure at port_a"
  extends Interfaces.PartialRestriction;
  parameter Units.AbsolutePressure p_open "Pressure at which it begins to open";
  parameter Units.AbsolutePressure p_full "Pressure at which it is fully open";
  parameter Units.Diameter d "Diameter of the flow area when fully open";
  parameter Units.Fraction leakage(min = 1e-9) = 1e-6 "Area of the closed valve over the full area; chosen: a few drops";
  parameter Units.Coefficient C_d = 0.7 "Discharge coefficient; chosen: as Orifice";
  parameter Units.Coefficient Re_crit = 100 "Reynolds number of the transition; chosen: as Orifice";
  Units.Area A "Flow area";
equation
  A = Constants.pi*d^2/4
    *(leakage + (1 - leakage)*Mechanics.Functions.smoothStep((port_a.p - p_open)/(p_full - p_open)));
  m_flow = Functions.restrictionMassFlow(dp, A, d, C_d, Re_crit, rho, fluid.nu);
  annotation(Documentation(info = "<html>
<p>Orifice equation with the area pi d<sup>2</sup>/4 smoothStep((p_a - p_open) / (p_full - p_open)). For a valve whose
spool moves see <code>Valves.ReliefValve</code>.</p>
</html>"));
end PressureRelief;
