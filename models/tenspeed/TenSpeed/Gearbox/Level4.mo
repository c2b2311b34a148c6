within TenSpeed.Gearbox;
model Level4 = Architecture(redeclare model Gearset = RigidGearset, redeclare model OutputGear = IdealOutputGear) "Gearbox at level 4";
