within TenSpeed.Interfaces;
partial model PartialGearset "Planetary gearset between three shafts"
  parameter Gearbox.GearsetData data "Geometry, elasticity and play";
  Mechanics.Rotational.Interfaces.Flange sun "Sun shaft";
  Mechanics.Rotational.Interfaces.Flange carrier "Carrier shaft";
  Mechanics.Rotational.Interfaces.Flange ring "Ring shaft";
  Mechanics.Units.Power lossPower "Power turned into heat";
  Mechanics.Units.Energy storedEnergy "Energy of motion of the planets, and elastic energy";
  annotation(Documentation(info = "<html>
<p>What every level of a gearset has in common.</p>
</html>"));
end PartialGearset;
