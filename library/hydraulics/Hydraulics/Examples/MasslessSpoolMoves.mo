within Hydraulics.Examples;
model MasslessSpoolMoves "A force moves a spool without mass and one that is always at rest"
  Mechanics.Translational.Sources.Force actuator(f_start = 20) "Actuator";
  Mechanics.Translational.Sources.Force slow(f_start = 0, f_end = 80, startTime = 0.02, duration = 0.06) "Actuator";
  Components.MasslessSpool spool(
    m = 0.02,
    c = 6e3,
    F_preload = 8,
    d = 30,
    s_max = 5e-3,
    s(fixed = true)) "Spool under test, between its stops";
  Components.StaticSpool static(
    m = 0.02,
    c = 6e3,
    F_preload = 22,
    s_max = 5e-3) "Spool under test, from stop to stop";
  output Mechanics.Units.Force error "Differences to the closed forms";
equation
  connect(actuator.flange, spool.flange);
  connect(slow.flange, static.flange);
  // Closed form s = (f - F_preload)/c (1 - exp(-c t/d)); balance of forces
  error = 6e3*(spool.s - 2e-3*(1 - exp(-200*time)))
    + abs(slow.f - static.springForce + static.stopForce);
  annotation(
    experiment(StopTime = 0.15, Tolerance = 1e-8),
    Documentation(info = "<html>
<p>The massless spool approaches its rest with the time constant d / c; the static one is there at once, also on its
stops.</p>
</html>"));
end MasslessSpoolMoves;
