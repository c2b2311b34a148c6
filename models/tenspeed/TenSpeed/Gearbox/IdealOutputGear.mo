within TenSpeed.Gearbox;
model IdealOutputGear "Output gear at levels 3 and 4: ideal ratio"
  extends Interfaces.PartialOutputGear;
  Mechanics.Rotational.Components.IdealGear gears(ratio = 1) "Gears";
equation
  connect(flange_a, gears.flange_a);
  connect(gears.flange_b, flange_b);
  lossPower = 0;
  storedEnergy = 0;
  annotation(Documentation(info = "<html>
<p>Ratio 1:1.</p>
</html>"));
end IdealOutputGear;
