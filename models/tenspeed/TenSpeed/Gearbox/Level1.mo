within TenSpeed.Gearbox;
model Level1 "Gearbox at level 1"
  extends Architecture(
    redeclare model Gearset = HelicalGearset,
    redeclare model OutputGear = HelicalOutputGear);
  annotation(Documentation(info = "<html>
<p>The architecture with every planet on its own, helical output gear.</p>
</html>"));
end Level1;
