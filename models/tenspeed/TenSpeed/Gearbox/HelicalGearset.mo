within TenSpeed.Gearbox;
model HelicalGearset "Gearset at level 1: individual planets"
  extends Interfaces.PartialGearset;
  Mechanics.Rotational.Components.HelicalPlanetary gears(
    final Z_s = data.Z_s,
    final Z_p = data.Z_p,
    final Z_r = data.Z_r,
    final N = data.N,
    final m_n = data.m_n,
    final beta = data.beta,
    final b_w = data.b_w,
    final rho = data.rho,
    final k_self = data.k_self,
    final k_orbit = data.k_orbit,
    final c_sun = data.c_mesh,
    final d_mesh = data.d_mesh,
    final b_mesh = data.b_mesh,
    final c_bearing = data.c_bearing,
    final d_bearing = data.d_bearing,
    final b_bearing = data.b_bearing) "Gears";
equation
  connect(sun, gears.sun);
  connect(carrier, gears.carrier);
  connect(ring, gears.ring);
  lossPower = gears.lossPower;
  storedEnergy = gears.storedEnergy;
  annotation(Documentation(info = "<html>
<p>Four states per planet: own rotation and motion about the main axis.</p>
</html>"));
end HelicalGearset;
