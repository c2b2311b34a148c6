within TenSpeed.Converter;
model LockupClutch "Friction clutch between impeller and turbine that sticks as a spring and damper"
  parameter Integer N_f(min = 1) = 2 "Number of friction surfaces; chosen: one plate";
  parameter Mechanics.Units.Length d_o = 0.24 "Outer diameter of the friction surfaces; chosen: fits the torus";
  parameter Mechanics.Units.Length d_i = 0.20 "Inner diameter of the friction surfaces; chosen: fits the torus";
  parameter Mechanics.Units.Ratio mu_0 = 0.13 "Friction coefficient of sticking plates; chosen: paper lining in oil";
  parameter Mechanics.Units.Ratio K_1 = 0.12 "Friction coefficient of slipping plates; chosen: paper lining in oil";
  parameter Mechanics.Units.RotationalTime K_2 = 0.5 "Shape of the transition; chosen: complete at 4 rad/s";
  parameter Mechanics.Units.RotationalTime K_3 = 1e-5 "Viscous rise; chosen: reaches mu_0 at 1000 rad/s";
  parameter Mechanics.Units.RotationalSpringConstant c(min = 1e-6) = 2e4
    "Stiffness of the sticking clutch; chosen: plate and the torsional damper behind it";
  parameter Mechanics.Units.RotationalDampingConstant d = 15 "Damping of the sticking clutch; chosen: decays in few cycles";
  parameter Mechanics.Units.AngularVelocity w_small(min = 0) = 0.01
    "Slip that counts as rest; chosen: far below any other, far above a solver's errors of fast shafts";
  final parameter Mechanics.Units.Length leverArm = (1.01 - N_f/100)*N_f/3*(d_o^3 - d_i^3)/(d_o^2 - d_i^2)
    "Torque over friction coefficient and normal force";
  Shaft impeller "Impeller";
  Shaft turbine "Turbine";
  Signals.Interfaces.RealInput f_normal(unit = "N") "Normal force; none where it is negative";
  Mechanics.Units.AngularVelocity slip "Speed of the impeller relative to the turbine";
  Mechanics.Units.Angle windUp(start = 0, nominal = 1e-2) "Elastic angle of the sticking clutch";
  Mechanics.Units.Torque tau "Torque from the impeller to the turbine";
  Mechanics.Units.Torque capacity "Torque that the sticking clutch transmits at most";
  Boolean stuck(start = false, fixed = true) "Whether the plates stick";
protected
  constant Mechanics.Units.RotationalDampingConstant unitDamping = 1 "Makes a torque of a slip";
  Mechanics.Units.Torque slipTorque "Magnitude of the torque of slipping plates";
  Mechanics.Units.Torque tau_stick "Torque of spring and damper without limit";
  Mechanics.Units.Torque breaking "Positive where sticking plates begin to slip";
  Mechanics.Units.AngularVelocity sticking "Positive where slipping plates stick";
  discrete Real direction(start = 1, fixed = true, final unit = "1") "Sign of the slip";
equation
  slip = impeller.w - turbine.w;
  impeller.tau = tau;
  turbine.tau = -tau;
  // Capacity
  capacity = mu_0*noEvent(max(f_normal, 0))*leverArm;
  slipTorque = Mechanics.Functions.frictionCoefficient(noEvent(abs(slip)), mu_0, K_1, K_2, K_3)
    *noEvent(max(f_normal, 0))*leverArm;
  // Spring and damper of the sticking clutch
  der(windUp) = if stuck then slip else 0;
  tau_stick = c*windUp + d*slip;
  // Plates slip once the capacity is exceeded, and stick again when the slip has died
  breaking = if pre(stuck) then noEvent(min(abs(tau_stick) - capacity, unitDamping*(sign(tau_stick)*slip - w_small)))
    else -1;
  sticking = if pre(stuck) then -1 else -pre(direction)*slip;
  stuck = if pre(stuck) then not breaking > 0 else sticking > 0;
  when not stuck then
    direction = noEvent(if slip > 0 then 1 else -1);
  end when;
  when stuck then
    reinit(windUp, pre(direction)*capacity/c);
  end when;
  // Torque
  tau = if stuck then smooth(0, noEvent(max(-capacity, min(capacity, tau_stick)))) else direction*slipTorque;
  annotation(Documentation(info = "<html>
<p>Slipping plates: tau = mu(|slip|) F f_i N_f (d_o<sup>3</sup> - d_i<sup>3</sup>) / (3 (d_o<sup>2</sup> -
d_i<sup>2</sup>)). Sticking plates: tau = c windUp + d slip, at most the capacity, with the wound-up angle as one state,
which is set when they stick so that the torque does not jump. No angle grows with the distance driven.</p>
</html>"));
end LockupClutch;
