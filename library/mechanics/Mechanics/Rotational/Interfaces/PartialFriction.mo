within Mechanics.Rotational.Interfaces;
partial model PartialFriction "Plate pack pressed together by a normal force"
  extends PartialCompliantWithSpeed;
  parameter Integer N_f(min = 1) = 6 "Number of friction surfaces; chosen: three friction plates";
  parameter Units.Length d_o = 0.16 "Outer diameter of the friction surfaces; chosen: usual for passenger cars";
  parameter Units.Length d_i = 0.13 "Inner diameter of the friction surfaces; chosen: usual for passenger cars";
  parameter Units.Ratio mu_0 = 0.13 "Friction coefficient of sticking plates; chosen: paper lining in transmission oil";
  parameter Units.Ratio K_1 = 0.12 "Friction coefficient of slipping plates; chosen: paper lining in transmission oil";
  parameter Units.RotationalTime K_2 = 0.5 "Shape of the transition; chosen: complete at 4 rad/s";
  parameter Units.RotationalTime K_3 = 5e-6 "Viscous rise; chosen: reaches mu_0 at 2000 rad/s, above any shaft";
  final parameter Real f_i(unit = "1") = 1.01 - N_f/100 "Loss of normal force in the pack";
  final parameter Units.Length leverArm = f_i*N_f/3*(d_o^3 - d_i^3)/(d_o^2 - d_i^2)
    "Torque over friction coefficient and normal force";
  Signals.Interfaces.RealInput f_normal(unit = "N") "Normal force; none where it is negative";
  Units.Torque capacity "Torque that sticking plates transmit at most";
  Units.Power lossPower "Power turned into heat";
protected
  Units.Force F "Normal force, never negative";
  Units.Torque slipTorque "Magnitude of the torque of slipping plates";
equation
  // Capacity
  F = noEvent(max(f_normal, 0));
  capacity = mu_0*F*leverArm;
  slipTorque = Functions.frictionCoefficient(noEvent(abs(w_rel)), mu_0, K_1, K_2, K_3)*F*leverArm;
  annotation(Documentation(info = "<html>
<p>Torque T = mu F f_i N_f (d_o<sup>3</sup> - d_i<sup>3</sup>) / (3 (d_o<sup>2</sup> - d_i<sup>2</sup>)) of a pack at
uniform pressure with f_i = 1.01 - N_f/100; mu of sticking plates gives the capacity, that of slipping plates
<code>Functions.frictionCoefficient</code>. The extending model says when the plates stick and slip.</p>
</html>"));
end PartialFriction;
