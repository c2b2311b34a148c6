within Hydraulics.Examples;
model SpoolBetweenStops "A force drives a spool from its lower to its upper end stop"
  Mechanics.Translational.Sources.Force actuator(f_start = 0, f_end = 80, startTime = 0.02, duration = 0.06)
    "Actuator";
  Components.Spool spool(
    m = 0.02,
    c = 6e3,
    F_preload = 22,
    dampingRatio = 0.3,
    s_max = 5e-3,
    s(fixed = true),
    v(fixed = true)) "Spool under test";
  output Mechanics.Units.Force error "Imbalance of forces, zero at rest";
equation
  connect(actuator.flange, spool.flange);
  // Balance at rest
  error = actuator.f - spool.springForce + spool.stopForce;
  annotation(
    experiment(StopTime = 0.15, Tolerance = 1e-6),
    Documentation(info = "<html>
<p>At the end s = s_max + (80 N - F_preload - c s) / c_stop. The contact makes no event.</p>
</html>"));
end SpoolBetweenStops;
