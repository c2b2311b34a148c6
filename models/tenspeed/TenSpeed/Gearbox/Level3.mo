within TenSpeed.Gearbox;
model Level3 "Gearbox at level 3"
  extends Architecture(
    redeclare model Gearset = ElasticGearset,
    redeclare model OutputGear = IdealOutputGear);
  annotation(Documentation(info = "<html>
<p>The architecture with elasticity and play at the suns, ideal output gear.</p>
</html>"));
end Level3;
