within Hydraulics.Components;
model MasslessSpool "Spool with spring, preload, damping and elastic end stops, its mass left out"
  extends Interfaces.PartialSpool;
  Mechanics.Units.Velocity v "Velocity";
equation
  // Motion
  v = der(s);
  // Elastic end stops, continuous in force
  stopForce = Mechanics.Functions.contactForce(s_min - s, 0, c_stop, 0)
    - Mechanics.Functions.contactForce(s - s_max, 0, c_stop, 0);
  // Balance of forces
  d*v = flange.f - springForce + stopForce;
  annotation(Documentation(info = "<html>
<p>d ds/dt = f - (F_preload + c s) + stopForce, by default d = 2 D sqrt(c m). At rest the same as <code>Spool</code>.</p>
</html>"));
end MasslessSpool;
