within Hydraulics.Components;
model SpoolEdge "Metering edge of a spool with overlap, chamfer, clearance and flow force"
  extends Interfaces.PartialSpoolEdge;
  parameter Mechanics.Units.Length chamfer(min = 0) = 0 "Axial length of the chamfer on the land";
  parameter Mechanics.Units.Angle chamferAngle = 0.5235987755982988
    "Angle of the chamfer to the axis; chosen: 30 degrees";
  Mechanics.Units.Length gap "Width of the metering gap";
equation
  // Geometry: sharp edge behind a chamfer, both closing smoothly to the clearance
  gap = sin(chamferAngle)*Functions.positivePart(displacement, clearance)
    + (1 - sin(chamferAngle))*Functions.positivePart(displacement - chamfer, clearance);
  A = Constants.pi*d*coverage*gap;
  // Annular gap: hydraulic diameter twice its width
  d_h = 2*gap;
  annotation(Documentation(info = "<html>
<p>Gap: h = sin(alpha) pos(x) + (1 - sin(alpha)) pos(x - l) with x = opening - overlap, chamfer length l and angle
alpha, pos the smooth positive part with the clearance (<code>Functions.positivePart</code>). Inside the chamfer the gap
stands perpendicular to the cone, behind it the gap grows with the full displacement. The edge never closes entirely:
what remains is the leakage through the clearance, falling with the covered length.</p>
<p>Area pi d h times the coverage, hydraulic diameter 2 h.</p>
</html>"));
end SpoolEdge;
