within Mechanics.Translational.Components;
model ElasticStops "Elastic, damped end stops of the case on both sides of a rod"
  extends Interfaces.PartialOneFlange;
  parameter Units.Position s_min "Position of the lower stop";
  parameter Units.Position s_max "Position of the upper stop";
  parameter Units.TranslationalSpringConstant c = 1e7 "Stiffness; nominal value of the study, 10 kN/mm";
  parameter Units.TranslationalDampingConstant d = 0 "Damping in contact";
  Units.Position s(start = 0) "Position";
  Units.Velocity v(start = 0) "Velocity";
  Units.Force f "Force on the rod";
  Units.Energy storedEnergy "Energy of the stops";
equation
  assert(s_min < s_max, "the lower stop must lie below the upper one");
  // Motion
  s = flange.s;
  v = der(s);
  // Contacts
  f = Functions.elasticContact(s_min - s, -v, c, d) - Functions.elasticContact(s - s_max, v, c, d);
  flange.f = -f;
  // Energy
  storedEnergy = Functions.backlashEnergy(s - (s_min + s_max)/2, s_max - s_min, c);
  annotation(Documentation(info = "<html>
<p>A spring with damping at either end, never pulling: <code>Functions.elasticContact</code>. No event.</p>
</html>"));
end ElasticStops;
