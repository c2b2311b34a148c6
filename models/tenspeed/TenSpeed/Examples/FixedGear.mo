within TenSpeed.Examples;
model FixedGear "Vehicle accelerates in one gear with constant input torque"
  parameter Integer gear(min = -1, max = 10) = 1 "Gear: 1 to 10, or -1 for reverse" annotation(Evaluate = true);
  parameter Mechanics.Units.Mass M = 1900 "Mass of the vehicle";
  parameter Mechanics.Units.Length R_tire = 0.33 "Radius of the tires";
  parameter Mechanics.Units.Ratio Z_FD = 3.61 "Ratio of the final drive";
  final parameter Integer row = if gear >= 1 and gear <= 10 then gear else 11 "Row of the gear table"
    annotation(Evaluate = true);
  Kinematics gearbox(engaged = GearTable.engaged[row, :]) "Gearbox";
  Mechanics.Rotational.Sources.Torque engine(tau_start = 150) "Torque of the turbine shaft";
  Mechanics.Rotational.Components.Inertia vehicle(
    J = M*(R_tire/Z_FD)^2,
    stateSelect = StateSelect.prefer) "Vehicle, as an inertia at the output gear";
  Mechanics.Units.AngularVelocity w_1 "Speed of the input";
  Mechanics.Units.AngularVelocity w_8 "Speed of the output";
  output Mechanics.Units.Ratio ratio "Speed of the input over speed of the output where the output turns, else 0";
equation
  assert(gear == -1 or gear >= 1 and gear <= 10, "gear must be 1 to 10, or -1 for reverse");
  // Drive and load
  connect(engine.flange, gearbox.flange_in);
  connect(gearbox.flange_out, vehicle.flange_a);
  // Observed ratio
  w_1 = gearbox.body[1].w;
  w_8 = gearbox.body[8].w;
  ratio = noEvent(if abs(w_8) > 1 then w_1/w_8 else 0);
  annotation(
    experiment(StopTime = 1, Tolerance = 1e-6),
    Documentation(info = "<html>
<p>Three engaged elements leave one degree of freedom, two states. The vehicle's mass M acts as the inertia
M (R_tire / Z_FD)<sup>2</sup> at the output gear.</p>
</html>"));
end FixedGear;
