within Mechanics.Translational.Components;
model Mass "Rigid body in translation"
  extends Interfaces.PartialTwoFlanges;
  parameter Units.Mass m "Mass";
  parameter StateSelect stateSelect = StateSelect.default "Priority of s and v as states";
  Units.Position s(start = 0, stateSelect = stateSelect) "Absolute position";
  Units.Velocity v(start = 0, stateSelect = stateSelect) "Absolute velocity";
  Units.Acceleration a(start = 0) "Absolute acceleration";
equation
  // One body: both ends move together
  flange_a.s = s;
  flange_b.s = s;
  // Motion
  v = der(s);
  a = der(v);
  // Newton's law
  m*a = flange_a.f + flange_b.f;
  annotation(Documentation(info = "<html>
<p>m d<sup>2</sup>s/dt<sup>2</sup> = f_a + f_b. The body has no length: both flanges are at s.</p>
</html>"));
end Mass;
