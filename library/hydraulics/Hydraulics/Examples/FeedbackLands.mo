within Hydraulics.Examples;
model FeedbackLands "One pressure on lands with an orifice, without one, and without oil"
  Sources.PressureSource supply(p_start = 2e5, p_end = 10e5, startTime = 0.01, duration = 0.05) "Pressure";
  Components.OrificeFeedback behind(
    redeclare model Chamber = Components.DecoupledChamber,
    A = 50e-6,
    V_0 = 2e-6,
    d_orifice = 1e-3) "Behind an orifice, its volume fixed";
  Components.DirectFeedback direct(
    pushes = Types.Direction.Negative,
    A = 30e-6,
    V_0 = 2e-6) "With the oil that the spool displaces";
  Components.PistonFace face(A = 10e-6) "Without oil";
  Components.Spool spool(
    m = 0.02,
    c = 10e3,
    F_preload = 5,
    dampingRatio = 0.5,
    s_max = 10e-3) "Spool";
  output Mechanics.Units.Force error "Imbalance of forces, zero at rest";
equation
  connect(supply.port, behind.port);
  connect(supply.port, direct.port);
  connect(supply.port, face.port);
  connect(behind.flange, spool.flange);
  connect(direct.flange, spool.flange);
  connect(face.flange, spool.flange);
  // Balance at rest
  error = (behind.A - direct.A + face.A)*(supply.port.p - Constants.p_atmosphere) - spool.springForce + spool.stopForce;
  annotation(
    experiment(StopTime = 0.3, Tolerance = 1e-6),
    Documentation(info = "<html>
<p>Three states: position and speed of the spool, pressure behind the orifice.</p>
</html>"));
end FeedbackLands;
