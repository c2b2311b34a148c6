within TenSpeed.Gearbox;
model ElasticGearset "Gearset at levels 2 and 3: elasticity and play at the sun"
  extends Interfaces.PartialGearset;
  Mechanics.Rotational.Components.ElasticPlanetary gears(
    final ratio = data.Z_r/data.Z_s,
    final c = data.c_lumped,
    final d = data.d_lumped,
    final b = data.b_lumped) "Gears";
  Mechanics.Rotational.Components.Inertia planets(J = data.N*data.J_orbit) "Planets, moving with the carrier";
equation
  connect(sun, gears.sun);
  connect(carrier, gears.carrier);
  connect(ring, gears.ring);
  connect(carrier, planets.flange_a);
  lossPower = gears.elasticity.lossPower;
  storedEnergy = gears.elasticity.storedEnergy + 0.5*planets.J*planets.w^2;
  annotation(Documentation(info = "<html>
<p>No state of its own: the planets move with the carrier, and their own rotation is neglected.</p>
</html>"));
end ElasticGearset;
