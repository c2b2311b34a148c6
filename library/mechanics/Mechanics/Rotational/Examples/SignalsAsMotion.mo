within Mechanics.Rotational.Examples;
model SignalsAsMotion "Inertias driven by signals of angle, speed and acceleration"
  Sources.PositionSignal angle "Prescribed angle";
  Sources.SpeedSignal speed(phi(start = 0, fixed = true)) "Prescribed speed";
  Sources.AccelerationSignal acceleration(phi(start = 0, fixed = true), w(start = 1, fixed = true)) "Prescribed acceleration";
  Sources.Acceleration constant_(a = 3, w_0 = 1) "Constant acceleration";
  Components.Inertia rotor[4](each J = 0.5) "Rotors";
  parameter Units.Angle phi_0 = 1 "Amplitude";
  parameter Real omega(unit = "rad/s") = 1 "Angular frequency";
  final parameter Units.AngularVelocity w_0 = phi_0*omega "Amplitude of the speed";
  final parameter Units.AngularAcceleration a_0 = w_0*omega "Amplitude of the acceleration";
  output Units.Ratio error "Difference to the closed form, relative";
equation
  connect(angle.flange, rotor[1].flange_a);
  connect(speed.flange, rotor[2].flange_a);
  connect(acceleration.flange, rotor[3].flange_a);
  connect(constant_.flange, rotor[4].flange_a);
  angle.phi = phi_0*sin(omega*time);
  speed.w = w_0*cos(omega*time);
  acceleration.a = -a_0*sin(omega*time);
  // Closed forms: the first three are sin(t) and its derivatives
  error = abs(rotor[2].phi/phi_0 - sin(omega*time)) + abs(rotor[3].phi/phi_0 - sin(omega*time))
    + abs(rotor[1].w/w_0 - cos(omega*time)) + abs(rotor[3].a/a_0 + sin(omega*time)) + abs(rotor[1].a/a_0 + sin(omega*time))
    + abs((rotor[4].w - constant_.w_0 - constant_.a*time)/w_0);
  annotation(
    experiment(StopTime = 3, Tolerance = 1e-8),
    Documentation(info = "<html>
<p>sin(t), cos(t) and -sin(t) as angle, speed and acceleration give one motion.</p>
</html>"));
end SignalsAsMotion;
