within Hydraulics.Examples;
model NotchedEdgeSweep "Notched edge moved from closed to open under constant pressure difference"
  Sources.Tank left(p_tank = 10e5) "Supply";
  Components.NotchedSpoolEdge edge(
    overlap = 1.5e-3,
    d = 14e-3,
    notch = 1e-3,
    clearance = 1e-6) "Edge under test";
  Sources.Tank right "Reservoir";
  Mechanics.Translational.Sources.Position actuator(s_end = 3e-3) "Prescribed position of the spool";
  output Units.Area error "Difference of the area to triangles and circumference without clearance";
protected
  Mechanics.Units.Length x "Position behind the tips of the notches";
equation
  connect(left.port, edge.port_a);
  connect(edge.port_b, right.port);
  connect(actuator.flange, edge.flange);
  // Closed form: triangles up to the length of the notch, then the whole circumference
  x = edge.flange.s - 0.5e-3;
  error = edge.A - 4*tan(edge.notchAngle)*max(0, min(1e-3, x))^2 - Constants.pi*14e-3*max(0, x - 1e-3);
  annotation(
    experiment(StopTime = 1, Tolerance = 1e-8),
    Documentation(info = "<html>
<p>4 tan(30 deg) 1 mm<sup>2</sup> when the edge begins to open.</p>
</html>"));
end NotchedEdgeSweep;
