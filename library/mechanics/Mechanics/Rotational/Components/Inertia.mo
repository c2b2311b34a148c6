within Mechanics.Rotational.Components;
model Inertia "Rigid rotating body"
  extends Interfaces.PartialTwoFlanges;
  parameter Units.Inertia J "Moment of inertia";
  parameter StateSelect stateSelect = StateSelect.default "Priority of phi and w as states";
  Units.Angle phi(start = 0, stateSelect = stateSelect) "Absolute angle";
  Units.AngularVelocity w(start = 0, stateSelect = stateSelect) "Absolute angular velocity";
  Units.AngularAcceleration a(start = 0) "Absolute angular acceleration";
equation
  // One body: both ends turn together
  flange_a.phi = phi;
  flange_b.phi = phi;
  // Motion
  w = der(phi);
  a = der(w);
  // Newton's law for rotation
  J*a = flange_a.tau + flange_b.tau;
  annotation(Documentation(info = "<html>
<p>J d<sup>2</sup>phi/dt<sup>2</sup> = tau_a + tau_b.</p>
</html>"));
end Inertia;
