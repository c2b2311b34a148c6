within TenSpeed.Gearbox;
model Level2 = Architecture(redeclare model Gearset = ElasticGearset, redeclare model OutputGear = HelicalOutputGear) "Gearbox at level 2";
