within TenSpeed.Gearbox;
model RigidGearset "Gearset at level 4: rigid"
  extends Interfaces.PartialGearset;
  Mechanics.Rotational.Components.RigidPlanetary gears(
    final Z_s = data.Z_s,
    final Z_p = data.Z_p,
    final Z_r = data.Z_r,
    final N = data.N,
    final J_self = data.J_self,
    final J_orbit = data.J_orbit) "Gears";
equation
  connect(sun, gears.sun);
  connect(carrier, gears.carrier);
  connect(ring, gears.ring);
  lossPower = 0;
  storedEnergy = gears.storedEnergy;
  annotation(Documentation(info = "<html>
<p>A constraint between the three shafts: it takes one degree of freedom away. The planets' inertia stays in.</p>
</html>"));
end RigidGearset;
