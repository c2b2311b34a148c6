within TenSpeed.Gearbox;
model HelicalOutputGear "Output gear at levels 1 and 2: elastic helical pair"
  extends Interfaces.PartialOutputGear;
  Mechanics.Rotational.Components.HelicalGearPair gears(
    Z_a = 60,
    Z_b = 60,
    m_n = 2e-3,
    beta = 0.45,
    c = 6e8,
    d = 3000,
    b = 50e-6) "Gears; chosen: a transfer pair of 60 teeth each, stiffness and play usual for its size";
equation
  connect(flange_a, gears.flange_a);
  connect(gears.flange_b, flange_b);
  lossPower = gears.lossPower;
  storedEnergy = gears.storedEnergy;
  annotation(Documentation(info = "<html>
<p>Ratio 1:1. The inertia behind it is a degree of freedom of its own.</p>
</html>"));
end HelicalOutputGear;
