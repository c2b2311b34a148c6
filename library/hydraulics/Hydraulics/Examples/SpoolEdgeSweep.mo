within Hydraulics.Examples;
model SpoolEdgeSweep "Metering edge moved from closed to open under constant pressure difference"
  Sources.Tank left(p_tank = 10e5) "Supply";
  Components.SpoolEdge edge(overlap = 1e-3, d = 14e-3, chamfer = 0.3e-3) "Edge under test";
  Sources.Tank right "Reservoir";
  Mechanics.Translational.Sources.Position actuator(s_end = 2e-3) "Prescribed position of the spool";
  output Mechanics.Units.Force error "Difference of the flow force to 2 C_d A dp cos(theta), small when open";
equation
  connect(left.port, edge.port_a);
  connect(edge.port_b, right.port);
  connect(actuator.flange, edge.flange);
  // Flow force in turbulent flow
  error = edge.flowForce - 2*edge.C_d*edge.A*edge.dp*cos(edge.jetAngle);
  annotation(
    experiment(StopTime = 1, Tolerance = 1e-6),
    Documentation(info = "<html>
<p>The flow grows smoothly from leakage to turbulent flow; the flow force closes the edge.</p>
</html>"));
end SpoolEdgeSweep;
