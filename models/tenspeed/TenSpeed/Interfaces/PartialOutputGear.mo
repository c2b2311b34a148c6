within TenSpeed.Interfaces;
partial model PartialOutputGear "Gear pair between ring 2 and the output shaft"
  extends Mechanics.Rotational.Interfaces.PartialTwoFlanges;
  Mechanics.Units.Power lossPower "Power turned into heat";
  Mechanics.Units.Energy storedEnergy "Elastic energy";
  annotation(Documentation(info = "<html>
<p>Flange_a is body 8, flange_b the output shaft; both count positive in the direction in which the vehicle drives
forward.</p>
</html>"));
end PartialOutputGear;
