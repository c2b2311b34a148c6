within Hydraulics.Interfaces;
partial model PartialSpoolEdge "Metering edge of a spool: flow through its area, force of its jet"
  extends PartialRestriction;
  parameter Types.Direction opens = Types.Direction.Positive "Direction of motion that opens the edge";
  parameter Mechanics.Units.Length overlap "Covered length at position 0, negative: open by so much";
  parameter Units.Diameter d "Diameter of the spool";
  parameter Units.Fraction coverage = 1 "Part of the circumference that is port";
  parameter Mechanics.Units.Length clearance(min = 1e-7) = 10e-6
    "Radial clearance; chosen: usual for transmission spools in aluminium bodies";
  parameter Units.Coefficient C_d = 0.7 "Discharge coefficient";
  parameter Units.Coefficient Re_crit = 100 "Reynolds number of the transition; chosen: as Orifice";
  parameter Boolean hasFlowForce = true "true: the jet pulls the edge shut" annotation(Evaluate = true);
  parameter Mechanics.Units.Angle jetAngle = 1.2042771838760873
    "Angle of the jet to the axis; von Mises: 69 degrees at a sharp edge";
  Mechanics.Translational.Interfaces.Flange flange "Spool";
  Mechanics.Units.Length displacement "Opening of the sharp edge, negative: covered";
  Units.Area A "Flow area";
  Units.Diameter d_h "Hydraulic diameter";
  Mechanics.Units.Force flowForce "Force of the jet, positive closes the edge";
protected
  final parameter Real orientation(final unit = "1") = if opens == Types.Direction.Positive then 1 else -1
    "Sign of the opening motion";
equation
  // Opening
  displacement = orientation*flange.s - overlap;
  // Flow through the area
  m_flow = Functions.restrictionMassFlow(dp, A, d_h, C_d, Re_crit, rho, fluid.nu);
  // Steady flow force: axial momentum of the jet
  flowForce = if hasFlowForce then m_flow^2*cos(jetAngle)/(rho*C_d*A) else 0;
  flange.f = orientation*flowForce;
  annotation(Documentation(info = "<html>
<p>Flow as in <code>Functions.restrictionMassFlow</code>. Flow force: m_flow v cos(theta) with the jet velocity
v = m_flow / (rho C_d A); in turbulent flow this is 2 C_d A dp cos(theta). Source: H. E. Merritt, Hydraulic Control
Systems, 1967, sections 3-4 and 5-6 (there theta = 69 degrees, after von Mises). The extending model gives area and
hydraulic diameter over the opening.</p>
</html>"));
end PartialSpoolEdge;
