within TenSpeed;
model Kinematics "Eight rigid bodies, four ideal planetary gearsets, seven ideal clutches and brakes"
  parameter Boolean engaged[7] "C1, C2, C3, B1, B2, B3, F1: true couples rigidly, false is free"
    annotation(Evaluate = true);
  parameter Mechanics.Units.Inertia J[8] = {0.02, 0.03, 0.02, 0.015, 0.004, 0.004, 0.006, 0.02}
    "Inertias of bodies 1 to 8";
  Mechanics.Rotational.Interfaces.Flange flange_in "Turbine shaft, body 1";
  Mechanics.Rotational.Interfaces.Flange flange_out "Output gear, body 8";
  // Bodies
  Mechanics.Rotational.Components.Inertia body[8](J = J) "Rotating bodies";
  // Gearsets
  Mechanics.Rotational.Components.IdealPlanetary P1(ratio = 130/42) "Ring 130, sun 42 teeth";
  Mechanics.Rotational.Components.IdealPlanetary P2(ratio = 81/43) "Ring 81, sun 43 teeth";
  Mechanics.Rotational.Components.IdealPlanetary P3(ratio = 103/37) "Ring 103, sun 37 teeth";
  Mechanics.Rotational.Components.IdealPlanetary P4(ratio = 76/48) "Ring 76, sun 48 teeth";
  // Clutches and brakes
  Mechanics.Rotational.Components.IdealEngagement C1(engaged = engaged[1]) "Clutch between bodies 1 and 4";
  Mechanics.Rotational.Components.IdealEngagement C2(engaged = engaged[2]) "Clutch between bodies 3 and 6";
  Mechanics.Rotational.Components.IdealEngagement C3(engaged = engaged[3]) "Clutch between bodies 1 and 7";
  Mechanics.Rotational.Components.IdealBrake B1(engaged = engaged[4]) "Brake of body 5";
  Mechanics.Rotational.Components.IdealBrake B2(engaged = engaged[5]) "Brake of body 6";
  Mechanics.Rotational.Components.IdealBrake B3(engaged = engaged[6]) "Brake of body 7";
  Mechanics.Rotational.Components.IdealBrake F1(engaged = engaged[7]) "Two-way clutch of body 4, held or free";
equation
  // Shafts
  connect(flange_in, body[1].flange_a);
  connect(body[8].flange_b, flange_out);
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
  connect(B1.flange, body[5].flange_b);
  connect(B2.flange, body[6].flange_b);
  connect(B3.flange, body[7].flange_b);
  connect(F1.flange, body[4].flange_b);
  annotation(Documentation(info = "<html>
<p>Bodies: 1 sun 3 (input); 2 carriers 3 and 4, ring 1; 3 ring 3, sun 2; 4 carriers 1 and 2; 5 sun 1; 6 sun 4;
7 ring 4; 8 ring 2 (output). Eight bodies less four gearsets leave four degrees of freedom; three engaged elements
leave one.</p>
</html>"));
end Kinematics;
