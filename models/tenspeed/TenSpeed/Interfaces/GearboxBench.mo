within TenSpeed.Interfaces;
partial model GearboxBench "Shift sweep of 50 s: reverse, park, neutral, up to tenth, down to first, and back"
  parameter Mechanics.Units.Torque tau_in = 150 "Input torque while it drives";
  parameter Hydraulics.Units.AbsolutePressure p_on = 12e5 "Pressure of an engaged element; chosen: line pressure at high load";
  parameter Hydraulics.Units.AbsolutePressure p_off = 1.6e5
    "Pressure of an open element; chosen: the largest piston does not move yet, so that all fill soon";
  parameter Mechanics.Units.Time duration = 0.5 "Duration of each pressure ramp";
  parameter Integer slack(min = 1) = 2
    "Of the upshifts: (1/2)^slack of the pressure is left half-way; chosen: hardly any tie-up, engine speed hardly rises"
    annotation(Evaluate = true);
  constant Integer row[25] = {11, 12, 12, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 12, 12, 11}
    "Sequence of gears: rows of the table of engagements, 12 for park and neutral";
  constant Real times[24](each unit = "s") =
    {2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30, 32, 34, 36, 38, 40, 42, 44, 46, 48}
    "Times at which the sequence goes on";
  constant Boolean engaged[12, 7] = cat(1, GearTable.engaged, {{false, false, false, false, true, false, false}})
    "The table of gears with park and neutral below it";
  replaceable Gearbox.Architecture gearbox constrainedby Gearbox.Architecture(
    cylinderB2(chamber(p(start = p_on)), piston(s(start = 5.117e-3))),
    cylinderC3(chamber(p(start = p_on)), piston(s(start = 5.139e-3)))) "Gearbox; reverse is engaged at the start";
  Gearbox.VehicleLoad vehicle "Vehicle";
  Mechanics.Rotational.Sources.TorqueSignal engine "Input torque";
  Mechanics.Rotational.Components.ElasticClutch brake(N_f = 2) "Brake on the output shaft";
  Mechanics.Rotational.Components.Fixed case "Case";
  Signals.Sources.SmoothSchedule pressure(
    times = times,
    values = {{if engaged[row[j], k] then p_on else p_off for j in 1:25} for k in 1:6},
    duration = duration,
    slack = {if j > 3 and j < 13 then slack else 1 for j in 1:24}) "Schedule of C1, C2, C3, B1, B2, B3";
  Signals.Sources.SmoothSteps torque(times = {2, 6, 25, 47}, values = {tau_in, 0, tau_in, 0, 0}) "Schedule of the input";
  Gearbox.BrakeSchedule brakeForce(
    J = vehicle.inertia.J,
    c_drag = vehicle.c_drag,
    leverArm = brake.leverArm) "Schedule of the brake";
  Gearbox.PressureLine line[6] "From schedule to pressure; may fail";
  Hydraulics.Sources.PressureSignal source[6] "Prescribed pressures";
  Hydraulics.Sources.PressureSource lockup(p_start = 1.1e5) "Lock-up clutch stays open";
  output Mechanics.Units.Ratio ratio "Speed of body 1 over speed of body 8 where it turns faster than 1 rad/s, else 0";
  output Mechanics.Units.Torque outputTorque "Torque of the gearbox on the output shaft";
  output Mechanics.Units.Torque inputTorque = engine.tau "Torque of the drive";
  output Mechanics.Units.Power inputPower "Power of the drive";
  output Mechanics.Units.Power outputPower "Power of the gearbox on the output shaft";
  output Integer gear "1 to 10, -1 in reverse, 0 in park and neutral: as commanded";
  output Mechanics.Units.AngularVelocity slip_C1 = gearbox.C1.w_rel "Slip of C1";
  output Mechanics.Units.AngularVelocity slip_C2 = gearbox.C2.w_rel "Slip of C2";
  output Mechanics.Units.AngularVelocity slip_C3 = gearbox.C3.w_rel "Slip of C3";
  output Mechanics.Units.AngularVelocity slip_B1 = gearbox.B1.w_rel "Slip of B1";
  output Mechanics.Units.AngularVelocity slip_B2 = gearbox.B2.w_rel "Slip of B2";
  output Mechanics.Units.AngularVelocity slip_B3 = gearbox.B3.w_rel "Slip of B3";
  output Mechanics.Units.AngularVelocity slip_F1 = gearbox.F1.w "Speed of the two-way clutch";
  output Mechanics.Units.Torque torque_C1 = gearbox.C1.tau "Torque of C1";
  output Mechanics.Units.Torque torque_C2 = gearbox.C2.tau "Torque of C2";
  output Mechanics.Units.Torque torque_C3 = gearbox.C3.tau "Torque of C3";
  output Mechanics.Units.Torque torque_B1 = gearbox.B1.tau "Torque of B1";
  output Mechanics.Units.Torque torque_B2 = gearbox.B2.tau "Torque of B2";
  output Mechanics.Units.Torque torque_B3 = gearbox.B3.tau "Torque of B3";
  output Mechanics.Units.Torque torque_F1 = gearbox.F1.tau "Torque of the two-way clutch";
equation
  // Drive and load
  connect(engine.flange, gearbox.flange_in);
  connect(torque.y, engine.tau);
  connect(gearbox.flange_out, vehicle.flange);
  connect(gearbox.flange_out, brake.flange_b);
  connect(brake.flange_a, case.flange);
  connect(brakeForce.y, brake.f_normal);
  brakeForce.w = vehicle.inertia.w;
  // Pressures
  connect(pressure.y, line.p_command);
  connect(line.p, source.p);
  connect(source.port, gearbox.port);
  connect(lockup.port, gearbox.portLockup);
  // Two-way clutch is locked both ways in reverse
  gearbox.lockBothWays = time < 2 or time >= 48;
  // Observed
  ratio = noEvent(if abs(gearbox.body[8].w) > 1 then gearbox.body[1].w/gearbox.body[8].w else 0);
  outputTorque = -gearbox.flange_out.tau;
  inputPower = engine.tau*gearbox.body[1].w;
  outputPower = outputTorque*vehicle.inertia.w;
  gear = if time < 2 or time >= 48 then -1
    elseif time < 6 or time >= 44 then 0
    elseif time < 26 then integer((time - 4)/2)
    else integer((46 - time)/2);
  annotation(Documentation(info = "<html>
<p>Input torque from 0 s on reverse; park at 2 s, neutral at 4 s, first at 6 s, an upshift every 2 s to tenth at 24 s;
input torque off and brake on at 25 s, a downshift every 2 s from 26 s to first at 42 s; neutral at 44 s, park at
46 s, reverse at 48 s. Pressures of oncoming and offgoing elements ramp at the same time, without feedback. In an upshift
both are low half-way: plates hold about twice the load at full pressure, and would tie up the gearbox otherwise.
Downshifts are those of a coasting vehicle: nothing drives that could run away, and pressures cross half-way.</p>
</html>"));
end GearboxBench;
