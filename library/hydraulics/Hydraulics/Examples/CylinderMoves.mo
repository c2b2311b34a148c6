within Hydraulics.Examples;
model CylinderMoves "A constant flow drives a cylinder against a restriction"
  Sources.FlowSource pump(q_start = 1e-4) "Pump";
  Components.Cylinder cylinder(
    A_a = 1e-3,
    A_b = 0.6e-3,
    s_max = 0.5,
    V_dead = 20e-6,
    m = 2,
    d = 500) "Cylinder under test";
  Components.Orifice orifice(d = 3e-3) "Restriction";
  Sources.Tank tank "Tank";
  output Real error(unit = "1") "Speed over that of an incompressible oil less 1, once it is steady";
equation
  connect(pump.port, cylinder.port_a);
  connect(cylinder.port_b, orifice.port_a);
  connect(orifice.port_b, tank.port);
  error = cylinder.piston.v*cylinder.A_a/pump.q_start - 1;
  annotation(
    experiment(StopTime = 3, Tolerance = 1e-8),
    Documentation(info = "<html>
<p>Steady, v = q / A_a. The oil in the growing chamber still takes up a little of the flow while pressures change.</p>
</html>"));
end CylinderMoves;
