within Hydraulics.Components;
model Spool "Spool with spring, preload, damping and elastic end stops"
  parameter Mechanics.Units.Mass m "Mass of the spool and of what moves with it";
  parameter Mechanics.Units.TranslationalSpringConstant c "Stiffness of the spring";
  parameter Mechanics.Units.Force F_preload "Force of the spring at position 0, pushes towards negative position";
  parameter Units.Coefficient dampingRatio = 0.05
    "Damping of spool and spring alone, relative to critical; chosen: the study's nominal damping factor";
  parameter Mechanics.Units.Position s_min = 0 "Position of the lower end stop";
  parameter Mechanics.Units.Position s_max "Position of the upper end stop";
  parameter Mechanics.Units.TranslationalSpringConstant c_stop = 1e6
    "Stiffness of the end stops; chosen: 1 kN/mm, a preloaded spool rests some hundredths of a millimetre deep";
  parameter Mechanics.Units.ContactDampingConstant b_stop = 1
    "Damping of the end stops relative to their elastic force; chosen: a spool that hits at 1 m/s rebounds at 0.6 m/s";
  final parameter Mechanics.Units.TranslationalDampingConstant d = 2*dampingRatio*sqrt(c*m) "Damping";
  Mechanics.Translational.Interfaces.Flange flange "Everything that acts on the spool";
  Mechanics.Units.Position s(start = 0, nominal = 1e-3, stateSelect = StateSelect.prefer) "Position";
  Mechanics.Units.Velocity v(start = 0, nominal = 0.1, stateSelect = StateSelect.prefer) "Velocity";
  Mechanics.Units.Acceleration a "Acceleration";
  Mechanics.Units.Force springForce "Force of the spring, positive pushes towards negative position";
  Mechanics.Units.Force stopForce "Force of both end stops, positive pushes towards positive position";
equation
  // Motion
  s = flange.s;
  v = der(s);
  a = der(v);
  // Preloaded spring
  springForce = F_preload + c*s;
  // Elastic end stops, continuous in force
  stopForce = Mechanics.Functions.contactForce(s_min - s, -v, c_stop, b_stop)
    - Mechanics.Functions.contactForce(s - s_max, v, c_stop, b_stop);
  // Newton's law
  m*a = flange.f - springForce - d*v + stopForce;
  annotation(Documentation(info = "<html>
<p>m d<sup>2</sup>s/dt<sup>2</sup> = f - (F_preload + c s) - d v + stopForce with d = 2 D sqrt(c m). End stops by
<code>Mechanics.Functions.contactForce</code>; they make no event.</p>
</html>"));
end Spool;
