within Mechanics.Translational.Examples;
model ClutchPistonAtPack "Piston is pushed through its lash onto the plate pack"
  Sources.Force push(f_start = 0, f_end = 5000, startTime = 0.05, duration = 0.5) "Force on the piston";
  Components.ClutchPiston piston "Piston";
  output Units.Force error "Difference to the balance of forces at rest";
equation
  connect(push.flange, piston.flange);
  // Closed form at rest: s = (f - F_preload + c_pack lash)/(c + c_pack)
  error = piston.f_normal
    - piston.c_pack*((push.f - piston.F_preload + piston.c_pack*piston.lash)/(piston.c + piston.c_pack) - piston.lash);
  annotation(
    experiment(StopTime = 1, Tolerance = 1e-6),
    Documentation(info = "<html>
<p>At rest on the pack f = F_preload + c s + c_pack (s - lash). <code>error</code> vanishes once the ramp is over.</p>
</html>"));
end ClutchPistonAtPack;
