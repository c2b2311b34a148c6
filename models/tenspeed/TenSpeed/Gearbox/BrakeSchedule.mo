within TenSpeed.Gearbox;
block BrakeSchedule "Normal force of the brake on the output shaft over the shift sweep, sized by the speed"
  parameter Mechanics.Units.Inertia J "Inertia of the vehicle at the output shaft";
  parameter Mechanics.Units.Inertia J_gearbox = 0.3 "Of the gearbox, seen there; chosen: mean of the gears";
  parameter Mechanics.Units.DragConstant c_drag "Drag over speed squared";
  parameter Mechanics.Units.Length leverArm "Torque of the brake over normal force and friction coefficient";
  parameter Mechanics.Units.Ratio mu = 0.1205 "Friction coefficient while it slips; chosen: of its plates at 100 rad/s";
  parameter Mechanics.Units.Torque tau_hold = 400 "Torque in park and neutral";
  parameter Mechanics.Units.AngularVelocity w_first = 108
    "Wanted speed when the shift to first begins; chosen: see the documentation";
  parameter Mechanics.Units.AngularVelocity w_end = 21.5 "Wanted speed at the end of first; chosen: above 20 rad/s";
  parameter Mechanics.Units.Ratio rest = 0.15 "Share of the last torque that remains; chosen: teeth stay in contact";
  parameter Mechanics.Units.Time duration = 0.5 "Duration of a ramp";
  Signals.Interfaces.RealInput w(unit = "rad/s") "Speed of the output shaft";
  Signals.Interfaces.RealOutput y(unit = "N") "Normal force";
  discrete Mechanics.Units.Torque tau_long(start = 0, fixed = true) "Torque from 25 s to 42 s";
  discrete Mechanics.Units.Torque tau_last(start = 0, fixed = true) "Torque from 42 s to 43.3 s; a share of it remains until 44 s";
protected
  constant Mechanics.Units.Time starts[6] = {2, 5.5, 25, 42, 43.3, 44} "Starts of the ramps";
  Mechanics.Units.Ratio rise[6] "Progress of the ramps";
equation
  // Change of momentum over time, less the mean drag at a speed that falls evenly
  when time >= starts[3] then
    tau_long = max(0, (J + J_gearbox)*(w - w_first)/(starts[4] - starts[3])
      - c_drag*(w^2 + w*w_first + w_first^2)/3);
  end when;
  when time >= starts[4] then
    tau_last = max(0, ((J + J_gearbox)*(w - w_end) - pre(tau_long)*duration/2)
      /(starts[5] - starts[4] + rest*(starts[6] - starts[5] - duration/2)) - c_drag*(w^2 + w*w_end + w_end^2)/3);
  end when;
  // Torques are given as forces on slipping plates
  rise = {Mechanics.Functions.smoothStep((time - t)/duration) for t in starts};
  y = (tau_hold*(rise[1] - rise[2] + rise[6]) + tau_long*(rise[3] - rise[4])
    + tau_last*(rise[4] - (1 - rest)*rise[5] - rest*rise[6]))/(mu*leverArm);
  annotation(Documentation(info = "<html>
<p>Holds the vehicle in park and neutral, and slows it from 25 s on so that it still moves at 44 s. There is no feedback:
each torque is sized once, from the speed at its start, because the speed depends on the input torque.</p>
<p>Why two torques: in first the one-way clutch of body 4 must lock again, and without input torque nothing but the
inertia of the input pulls body 4 back. With brakes B1 and B2 applied w_4 falls by about 0.93 rad/s for each rad/s of
the output, from 0.65 w_8 in second: it reaches zero once the output has slowed to 0.3 of its speed when C2 opens. So
the vehicle comes to the last downshift at 100 rad/s, 33 km/h, and within the two seconds of first goes to 7 km/h,
which takes a firm half of the acceleration of gravity.</p>
</html>"));
end BrakeSchedule;
