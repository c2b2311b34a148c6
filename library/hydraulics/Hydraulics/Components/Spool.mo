within Hydraulics.Components;
model Spool "Spool with mass, spring, preload, damping and elastic end stops"
  extends Interfaces.PartialSpool;
  Mechanics.Units.Velocity v(start = 0, nominal = 0.1, stateSelect = StateSelect.prefer) "Velocity";
  Mechanics.Units.Acceleration a "Acceleration";
equation
  // Motion
  v = der(s);
  a = der(v);
  // Elastic end stops, continuous in force
  stopForce = Mechanics.Functions.contactForce(s_min - s, -v, c_stop, b_stop)
    - Mechanics.Functions.contactForce(s - s_max, v, c_stop, b_stop);
  // Newton's law
  m*a = flange.f - springForce - d*v + stopForce;
  annotation(Documentation(info = "<html>
<p>m d<sup>2</sup>s/dt<sup>2</sup> = f - (F_preload + c s) - d v + stopForce, by default d = 2 D sqrt(c m). End stops by
<code>Mechanics.Functions.contactForce</code>; they make no event.</p>
</html>"));
end Spool;
