within TenSpeed.Gearbox;
model Level4 "Gearbox at level 4"
  extends Architecture(
    redeclare model Gearset = RigidGearset,
    redeclare model OutputGear = IdealOutputGear);
  annotation(Documentation(info = "<html>
<p>The architecture with rigid gearsets, ideal output gear.</p>
</html>"));
end Level4;
