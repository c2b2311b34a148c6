within TenSpeed.Gearbox;
model Architecture "Eight bodies, four gearsets, three clutches, three brakes, two-way clutch and their cylinders"
  replaceable package Oil = Hydraulics.Media.OilDexronVI constrainedby Hydraulics.Media.PartialOil
    "Oil whose data are the default" annotation(choicesAllMatching = true);
  parameter Hydraulics.Media.Fluid fluid = Oil.data "Oil";
  parameter Mechanics.Units.Inertia J[8] = {0.02, 0.03, 0.02, 0.015, 0.004, 0.004, 0.006, 0.02}
    "Inertias of bodies 1 to 8";
  // Shafts and pressures
  Mechanics.Rotational.Interfaces.Flange flange_in "Turbine shaft, body 1";
  Mechanics.Rotational.Interfaces.Flange flange_out "Output shaft";
  Hydraulics.Interfaces.Port port[6] "Pressures of C1, C2, C3, B1, B2, B3, upstream of the feed orifices";
  Hydraulics.Interfaces.Port portLockup "Pressure of the lock-up clutch, upstream of its feed orifice";
  Signals.Interfaces.BooleanInput lockBothWays "Command of the two-way clutch";
  Signals.Interfaces.RealOutput lockupForce(unit = "N") "Normal force of the lock-up clutch";
  Mechanics.Units.Power lossPower "Power taken by gears, clutches, brakes and two-way clutch";
  Mechanics.Units.Energy storedEnergy "Energy of motion, and elastic energy of gears";
  // Bodies
  Mechanics.Rotational.Components.Inertia body[8](J = J, each stateSelect = StateSelect.prefer) "Rotating bodies";
  // Gearsets
  replaceable model Gearset = RigidGearset constrainedby Interfaces.PartialGearset "Level of the gearsets"
    annotation(choicesAllMatching = true);
  replaceable model OutputGear = IdealOutputGear constrainedby Interfaces.PartialOutputGear "Level of the output gear"
    annotation(choicesAllMatching = true);
  Gearset P1(data = Data.P1) "Sun 5, carrier 4, ring 2";
  Gearset P2(data = Data.P2) "Sun 3, carrier 4, ring 8";
  Gearset P3(data = Data.P3) "Sun 1, carrier 2, ring 3";
  Gearset P4(data = Data.P4) "Sun 6, carrier 2, ring 7";
  OutputGear outputGear "Body 8 to the output shaft";
  // Friction elements
  replaceable model Clutch = Mechanics.Rotational.Components.ElasticClutch
    constrainedby Mechanics.Rotational.Interfaces.PartialFriction "Friction law"
    annotation(choicesAllMatching = true);
  // Friction surfaces: chosen so that at 12 bar slipping plates carry 250 N.m of input torque, and a third more, in any gear
  Clutch C1(N_f = 10) "Bodies 1 and 4";
  Clutch C2(N_f = 8) "Bodies 3 and 6";
  Clutch C3(N_f = 12) "Bodies 1 and 7";
  Clutch B1(N_f = 10) "Body 5 and case";
  Clutch B2(N_f = 8) "Body 6 and case";
  Clutch B3(N_f = 4) "Body 7 and case";
  Mechanics.Rotational.Components.TwoWayClutch F1 "Body 4 and case";
  Mechanics.Rotational.Components.Fixed case "Case";
  // Cylinders; outer radius of the cancellation chambers chosen: open clutches stay open up to 700 rad/s
  parameter Hydraulics.Units.Diameter d_feed = 5e-3 "Feed orifices; chosen: a cylinder fills within 0.1 s";
  Hydraulics.Components.ClutchCylinder cylinderC1(final fluid = fluid, d_feed = d_feed, A = 70e-4, rotating = true, r_oc = 0.079) "Of C1";
  Hydraulics.Components.ClutchCylinder cylinderC2(final fluid = fluid, d_feed = d_feed, A = 60e-4, rotating = true, r_oc = 0.079) "Of C2";
  Hydraulics.Components.ClutchCylinder cylinderC3(final fluid = fluid, d_feed = d_feed, A = 70e-4, rotating = true, r_oc = 0.079) "Of C3";
  Hydraulics.Components.ClutchCylinder cylinderB1(final fluid = fluid, d_feed = d_feed, A = 60e-4) "Of B1";
  Hydraulics.Components.ClutchCylinder cylinderB2(final fluid = fluid, d_feed = d_feed, A = 60e-4) "Of B2";
  Hydraulics.Components.ClutchCylinder cylinderB3(final fluid = fluid, d_feed = d_feed, A = 80e-4) "Of B3";
  Hydraulics.Components.ClutchCylinder cylinderLockup(final fluid = fluid, d_feed = d_feed, A = 200e-4) "Of the lock-up clutch";
equation
  // Shafts
  connect(flange_in, body[1].flange_a);
  connect(body[8].flange_b, outputGear.flange_a);
  connect(outputGear.flange_b, flange_out);
  // Gearset P1
  connect(P1.sun, body[5].flange_a);
  connect(P1.carrier, body[4].flange_a);
  connect(P1.ring, body[2].flange_a);
  // Gearset P2
  connect(P2.sun, body[3].flange_a);
  connect(P2.carrier, body[4].flange_a);
  connect(P2.ring, body[8].flange_a);
  // Gearset P3
  connect(P3.sun, body[1].flange_b);
  connect(P3.carrier, body[2].flange_a);
  connect(P3.ring, body[3].flange_a);
  // Gearset P4
  connect(P4.sun, body[6].flange_a);
  connect(P4.carrier, body[2].flange_a);
  connect(P4.ring, body[7].flange_a);
  // Clutches
  connect(C1.flange_a, body[1].flange_b);
  connect(C1.flange_b, body[4].flange_b);
  connect(C2.flange_a, body[3].flange_b);
  connect(C2.flange_b, body[6].flange_b);
  connect(C3.flange_a, body[1].flange_b);
  connect(C3.flange_b, body[7].flange_b);
  // Brakes
  connect(B1.flange_a, case.flange);
  connect(B1.flange_b, body[5].flange_b);
  connect(B2.flange_a, case.flange);
  connect(B2.flange_b, body[6].flange_b);
  connect(B3.flange_a, case.flange);
  connect(B3.flange_b, body[7].flange_b);
  connect(F1.flange, body[4].flange_b);
  connect(lockBothWays, F1.lockBothWays);
  // Pressures
  connect(port[1], cylinderC1.port);
  connect(port[2], cylinderC2.port);
  connect(port[3], cylinderC3.port);
  connect(port[4], cylinderB1.port);
  connect(port[5], cylinderB2.port);
  connect(port[6], cylinderB3.port);
  connect(portLockup, cylinderLockup.port);
  // Rotation of the cylinders: C1 and C3 turn with body 1, C2 with body 3, the others stand still
  cylinderC1.w = body[1].w;
  cylinderC2.w = body[3].w;
  cylinderC3.w = body[1].w;
  cylinderB1.w = 0;
  cylinderB2.w = 0;
  cylinderB3.w = 0;
  cylinderLockup.w = 0;
  // Normal forces
  connect(cylinderC1.f_normal, C1.f_normal);
  connect(cylinderC2.f_normal, C2.f_normal);
  connect(cylinderC3.f_normal, C3.f_normal);
  connect(cylinderB1.f_normal, B1.f_normal);
  connect(cylinderB2.f_normal, B2.f_normal);
  connect(cylinderB3.f_normal, B3.f_normal);
  connect(cylinderLockup.f_normal, lockupForce);
  // Energy; what sticking plates store counts as taken by them
  lossPower = P1.lossPower + P2.lossPower + P3.lossPower + P4.lossPower + outputGear.lossPower
    + C1.tau*C1.w_rel + C2.tau*C2.w_rel + C3.tau*C3.w_rel + B1.tau*B1.w_rel + B2.tau*B2.w_rel + B3.tau*B3.w_rel
    + F1.lossPower;
  storedEnergy = 0.5*(J*(body.w.^2)) + P1.storedEnergy + P2.storedEnergy + P3.storedEnergy + P4.storedEnergy
    + outputGear.storedEnergy;
  annotation(Documentation(info = "<html>
<p>Seven cylinders with three states each are 21; the rest are angles and speeds: of all eight bodies with elastic
gearsets, of four degrees of freedom with rigid ones.</p>
</html>"));
end Architecture;
