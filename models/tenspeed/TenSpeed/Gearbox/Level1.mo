within TenSpeed.Gearbox;
model Level1 = Architecture(redeclare model Gearset = HelicalGearset, redeclare model OutputGear = HelicalOutputGear) "Gearbox at level 1";
