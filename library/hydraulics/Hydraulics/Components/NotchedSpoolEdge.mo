within Hydraulics.Components;
model NotchedSpoolEdge "Metering edge of a spool with triangular notches that open first"
  extends Interfaces.PartialSpoolEdge;
  parameter Integer n(min = 1) = 4 "Number of notches";
  parameter Mechanics.Units.Length notch "Axial length of a notch";
  parameter Mechanics.Units.Angle notchAngle = 0.5235987755982988
    "Half the angle at the tip of a notch; chosen: 30 degrees";
  Mechanics.Units.Length gap "Width of the annular gap behind the notches";
  Mechanics.Units.Length open "Open length of a notch";
equation
  // Geometry: notches ahead of the edge, then the whole circumference; both close smoothly to the clearance
  gap = Functions.positivePart(displacement, clearance);
  open = Functions.positivePart(displacement + notch, clearance) - gap;
  A = n*tan(notchAngle)*open^2 + Constants.pi*d*coverage*gap;
  // Four times the area over the wetted circumference
  d_h = 4*A/(2*Constants.pi*d*coverage + 2*n*open*(tan(notchAngle) + 1/cos(notchAngle)));
  annotation(Documentation(info = "<html>
<p>Each notch is a triangle of half angle alpha whose tip opens <code>notch</code> ahead of the edge: its area is
tan(alpha) y<sup>2</sup> with the open length y, from 0 to the whole notch. Behind it pi d x of the edge opens, times the
coverage. Small flows are metered by the notches with a gain that grows from zero.</p>
</html>"));
end NotchedSpoolEdge;
