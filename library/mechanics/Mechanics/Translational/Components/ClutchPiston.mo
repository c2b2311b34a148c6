within Mechanics.Translational.Components;
model ClutchPiston "Piston with return spring, damping and lash before a plate pack"
  extends Interfaces.PartialOneFlange;
  parameter Units.Mass m = 0.2 "Mass; chosen: 200 g";
  parameter Units.TranslationalSpringConstant c = 50e3 "Return spring; chosen: 50 N/mm";
  parameter Units.Force F_preload = 500 "Preload of the return spring; chosen: about 0.8 bar on 60 cm2";
  parameter Units.TranslationalDampingConstant d = 500 "Damping; chosen: 500 N s/m";
  parameter Units.Length lash = 5e-3 "Way to the plate pack; chosen: 5 mm";
  parameter Units.TranslationalSpringConstant c_pack = 50e6 "Stiffness of the plate pack; chosen: 0.1 mm at 5 kN";
  parameter Units.TranslationalDampingConstant d_pack = 5e3 "Damping of the plate pack; chosen: well damped";
  parameter Units.TranslationalSpringConstant c_stop = 50e6
    "Stiffness of the stop on which the open piston rests; chosen: as the pack";
  parameter Units.TranslationalDampingConstant d_stop = 5e3 "Damping of that stop; chosen: as the pack";
  Signals.Interfaces.RealOutput f_normal(unit = "N") "Force on the plate pack";
  Units.Position s(start = 0, nominal = 1e-3, stateSelect = StateSelect.prefer) "Position, 0 at rest";
  Units.Velocity v(start = 0, nominal = 0.1, stateSelect = StateSelect.prefer) "Velocity";
  Units.Force stopForce "Of the stop on which the open piston rests";
equation
  // Motion
  s = flange.s;
  v = der(s);
  // Contacts
  f_normal = Functions.elasticContact(s - lash, v, c_pack, d_pack);
  stopForce = Functions.elasticContact(-s, -v, c_stop, d_stop);
  // Newton's law
  m*der(v) = flange.f + stopForce - F_preload - c*s - d*v - f_normal;
  annotation(Documentation(info = "<html>
<p>m d<sup>2</sup>s/dt<sup>2</sup> = f - F_preload - c s - d v - f_normal + stopForce. The plate pack is a spring with
damping behind the lash; its force presses the plates. Both contacts are <code>Functions.elasticContact</code> and make
no event.</p>
</html>"));
end ClutchPiston;
