within TenSpeed.Gearbox;
model Level2 "Gearbox at level 2"
  extends Architecture(
    redeclare model Gearset = ElasticGearset,
    redeclare model OutputGear = HelicalOutputGear);
  annotation(Documentation(info = "<html>
<p>The architecture with elasticity and play at the suns, helical output gear.</p>
</html>"));
end Level2;
