within Hydraulics.Components;
model SpoolEdge "Metering edge of a spool with overlap, chamfer, clearance and flow force"
  extends Interfaces.PartialRestriction;
  parameter Types.Direction opens = Types.Direction.Positive "Direction of motion that opens the edge";
  parameter Mechanics.Units.Length overlap "Covered length at position 0, negative: open by so much";
  parameter Units.Diameter d "Diameter of the spool";
  parameter Units.Fraction coverage = 1 "Part of the circumference that is port";
  parameter Mechanics.Units.Length clearance(min = 1e-7) = 10e-6
    "Radial clearance; chosen: usual for transmission spools in aluminium bodies";
  parameter Mechanics.Units.Length chamfer(min = 0) = 0 "Axial length of the chamfer on the land";
  parameter Mechanics.Units.Angle chamferAngle = 0.5235987755982988
    "Angle of the chamfer to the axis; chosen: 30 degrees";
  parameter Units.Coefficient C_d = 0.7 "Discharge coefficient";
  parameter Units.Coefficient Re_crit = 100 "Reynolds number of the transition; chosen: as Orifice";
  parameter Boolean hasFlowForce = true "true: the jet pulls the edge shut" annotation(Evaluate = true);
  parameter Mechanics.Units.Angle jetAngle = 1.2042771838760873
    "Angle of the jet to the axis; von Mises: 69 degrees at a sharp edge";
  Mechanics.Translational.Interfaces.Flange flange "Spool";
  Mechanics.Units.Length displacement "Opening of the sharp edge, negative: covered";
  Mechanics.Units.Length gap "Width of the metering gap";
  Units.Area A "Flow area";
  Mechanics.Units.Force flowForce "Force of the jet, positive closes the edge";
protected
  final parameter Real orientation(final unit = "1") = if opens == Types.Direction.Positive then 1 else -1
    "Sign of the opening motion";
equation
  // Geometry: sharp edge behind a chamfer, both closing smoothly to the clearance
  displacement = orientation*flange.s - overlap;
  gap = sin(chamferAngle)*Functions.positivePart(displacement, clearance)
    + (1 - sin(chamferAngle))*Functions.positivePart(displacement - chamfer, clearance);
  A = Constants.pi*d*coverage*gap;
  // Flow through the annular gap, hydraulic diameter twice its width
  m_flow = Functions.restrictionMassFlow(dp, A, 2*gap, C_d, Re_crit, rho, fluid.nu);
  // Steady flow force: axial momentum of the jet
  flowForce = if hasFlowForce then m_flow^2*cos(jetAngle)/(rho*C_d*A) else 0;
  flange.f = orientation*flowForce;
  annotation(Documentation(info = "<html>
<p>Gap: h = sin(alpha) pos(x) + (1 - sin(alpha)) pos(x - l) with x = opening - overlap, chamfer length l and angle
alpha, pos the smooth positive part with the clearance (<code>Functions.positivePart</code>). Inside the chamfer the gap
stands perpendicular to the cone, behind it the gap grows with the full displacement. The edge never closes entirely:
what remains is the leakage through the clearance, falling with the covered length.</p>
<p>Area pi d h times the coverage, hydraulic diameter 2 h, flow as in <code>Functions.restrictionMassFlow</code>.</p>
<p>Flow force: m_flow v cos(theta) with the jet velocity v = m_flow / (rho C_d A); in turbulent flow this is
2 C_d A dp cos(theta). Source: H. E. Merritt, Hydraulic Control Systems, 1967, sections 3-4 and 5-6 (there
theta = 69 degrees, after von Mises).</p>
</html>"));
end SpoolEdge;
