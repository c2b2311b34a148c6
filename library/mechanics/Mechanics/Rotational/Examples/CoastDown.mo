within Mechanics.Rotational.Examples;
model CoastDown "A vehicle slows down by its drag, measured on the shaft"
  parameter Units.AngularVelocity w_0 = 400 "Initial speed";
  Components.VehicleLoad vehicle(M = 1500, R_tire = 0.3, Z_FD = 3, C_DA = 0.7, inertia(w(start = w_0, fixed = true)))
    "Vehicle";
  Sensors.MotionSensor motion "Motion of the shaft";
  Sensors.PowerSensor power "Power that a free shaft takes";
  Sensors.RelativeMotionSensor relative "Against the case";
  Components.Inertia shaft(J = 1e-6) "Free shaft";
  Components.Fixed case "Case";
  final parameter Units.Inertia J = 1e-6 + vehicle.inertia.J "All inertia";
  final parameter Units.Power P_0 = 1000 "Power that counts as an error of 1";
  output Real error(unit = "1") "Difference to the closed form, relative";
equation
  connect(shaft.flange_b, power.flange_a);
  connect(power.flange_b, vehicle.flange);
  connect(motion.flange, vehicle.flange);
  connect(relative.flange_a, case.flange);
  connect(relative.flange_b, vehicle.flange);
  // Closed form: J dw/dt = -c w^2; the light shaft gives its own share of the power
  error = abs(motion.w*(1/w_0 + vehicle.c_drag*time/J) - 1) + abs(relative.w_rel/w_0 - motion.w/w_0)
    + abs(power.P/P_0 - power.tau*motion.w/P_0);
  annotation(
    experiment(StopTime = 60, Tolerance = 1e-8),
    Documentation(info = "<html>
<p>w = 1/(1/w_0 + c t/J) with the drag c w<sup>2</sup>.</p>
</html>"));
end CoastDown;
