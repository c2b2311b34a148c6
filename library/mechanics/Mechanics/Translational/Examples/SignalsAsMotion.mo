within Mechanics.Translational.Examples;
model SignalsAsMotion "Masses driven by signals of position, speed, acceleration and force"
  Sources.PositionSignal position "Prescribed position";
  Sources.SpeedSignal speed(s(start = 0, fixed = true)) "Prescribed speed";
  Sources.AccelerationSignal acceleration(s(start = 0, fixed = true), v(start = 1, fixed = true)) "Prescribed acceleration";
  Sources.ForceSignal force "Prescribed force";
  Sources.Acceleration constant_(a = 3, v_0 = 1) "Constant acceleration";
  Sources.Speed ramp(v_start = 1, v_end = 2, duration = 2) "Speed ramp";
  Sensors.ForceSensor sensor "Force on the first mass";
  Sensors.MotionSensor motion "Motion of the last one";
  Components.Mass body[6](each m = 0.5, each s(start = 0), each v(start = 1)) "Masses";
  parameter Units.Position s_0 = 1 "Amplitude";
  parameter Real omega(unit = "rad/s") = 1 "Angular frequency";
  final parameter Units.Velocity v_0 = s_0*omega "Amplitude of the speed";
  final parameter Units.Acceleration a_0 = v_0*omega "Amplitude of the acceleration";
  final parameter Units.Force f_0 = 0.5*a_0 "Amplitude of the force; 0.5: the mass";
  output Units.Ratio error "Difference to the closed form, relative";
initial equation
  body[4].s = 0;
  body[4].v = 1;
equation
  connect(position.flange, sensor.flange_a);
  connect(sensor.flange_b, body[1].flange_a);
  connect(speed.flange, body[2].flange_a);
  connect(acceleration.flange, body[3].flange_a);
  connect(force.flange, body[4].flange_a);
  connect(constant_.flange, body[5].flange_a);
  connect(ramp.flange, body[6].flange_a);
  connect(motion.flange, body[6].flange_b);
  position.s = s_0*sin(omega*time);
  speed.v = v_0*cos(omega*time);
  acceleration.a = -a_0*sin(omega*time);
  force.f = -f_0*sin(omega*time);
  // Closed forms: the first four are sin(t) and its derivatives
  error = abs(body[2].s/s_0 - sin(omega*time)) + abs(body[3].s/s_0 - sin(omega*time))
    + abs(body[1].v/v_0 - cos(omega*time)) + abs(body[4].s/s_0 - sin(omega*time))
    + abs((body[5].v - constant_.v_0 - constant_.a*time)/v_0) + abs(sensor.f/f_0 + sin(omega*time))
    + abs((motion.v - ramp.v_start)/(ramp.v_end - ramp.v_start) - Functions.smoothStep(time/ramp.duration));
  annotation(
    experiment(StopTime = 3, Tolerance = 1e-8),
    Documentation(info = "<html>
<p>sin(t), cos(t) and -sin(t) as position, speed and acceleration, and m times the latter as force, give one motion.</p>
</html>"));
end SignalsAsMotion;
