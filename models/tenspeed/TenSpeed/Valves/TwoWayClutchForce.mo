within TenSpeed.Valves;
model TwoWayClutchForce "Two-way-clutch valve at level 4: a mass under one net force, no detents"
  extends Interfaces.PartialTwoWayClutchStage;
  Hydraulics.Components.Spool spool(
    final m = m,
    final c = 0,
    final F_preload = 0,
    final d = d,
    final s_max = stroke,
    b_stop = 5) "Spool between its stops";
  Mechanics.Units.Force net "Force of the pressures";
  Mechanics.Translational.Sources.ForceSignal force "On the spool";
equation
  net = A*sum(drive[k].p - reverse[k].p for k in 1:2);
  force.f = net;
  connect(force.flange, spool.flange);
  s = spool.s;
  // Nothing is displaced
  for k in 1:2 loop
    drive[k].q = 0;
    reverse[k].q = 0;
  end for;
  m_oil = 0;
  annotation(Documentation(info = "<html>
<p>m d<sup>2</sup>s/dt<sup>2</sup> = net - d v between the stops. Without pressure the spool stays where it is.</p>
</html>"));
end TwoWayClutchForce;
