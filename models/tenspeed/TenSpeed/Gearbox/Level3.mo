within TenSpeed.Gearbox;
model Level3 = Architecture(redeclare model Gearset = ElasticGearset, redeclare model OutputGear = IdealOutputGear) "Gearbox at level 3";
