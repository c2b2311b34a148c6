within Mechanics.Rotational.Components;
model ElasticClutch "Friction clutch that sticks as a spring and damper up to its capacity"
  extends Interfaces.PartialFriction;
  parameter Units.RotationalSpringConstant c(min = 1e-6) = 2e5
    "Stiffness of the sticking plates; chosen: linear in the plate thickness, 1e5 N.m/rad per millimetre";
  parameter Units.RotationalDampingConstant d = 50 "Damping of the sticking plates; chosen: decays within few cycles";
  parameter Units.AngularVelocity w_small(min = 0) = 1e-4 "Slip that counts as rest; chosen: far below any shift's";
  Boolean stuck(start = true, fixed = true) "Whether the plates stick";
  discrete Units.Angle phi_lock(start = 0, fixed = true) "Relative angle at which the sticking plates carry no torque";
  Units.Angle windUp "Elastic angle of the sticking plates";
protected
  constant Units.RotationalDampingConstant unitDamping = 1 "Makes a torque of a slip";
  Units.Torque breaking "Positive where sticking plates begin to slip";
  Units.AngularVelocity sticking "Positive where slipping plates stick";
  Units.Torque tau_stick "Torque of spring and damper without limit";
  discrete Real direction(start = 1, fixed = true, final unit = "1") "Sign of the slip";
equation
  // Spring and damper about the angle of lock
  windUp = phi_rel - phi_lock;
  tau_stick = c*windUp + d*w_rel;
  // Plates slip once the capacity is exceeded, and stick again when the slip has died
  breaking = if pre(stuck) then noEvent(min(abs(tau_stick) - capacity, unitDamping*(sign(tau_stick)*w_rel - w_small)))
    else -1;
  sticking = if pre(stuck) then -1 else -pre(direction)*w_rel;
  stuck = if pre(stuck) then not breaking > 0 else sticking > 0;
  when not stuck then
    direction = noEvent(if w_rel > 0 then 1 else -1);
  end when;
  when stuck then
    phi_lock = phi_rel - pre(direction)*capacity/c;
  end when;
  // Torque
  tau = if stuck then smooth(0, noEvent(max(-capacity, min(capacity, tau_stick)))) else direction*slipTorque;
  // Energy
  lossPower = if stuck then (tau - smooth(0, noEvent(max(-capacity, min(capacity, c*windUp)))))*w_rel else tau*w_rel;
  annotation(Documentation(info = "<html>
<p>Sticking plates: tau = c (phi_rel - phi_lock) + d w_rel, at most the capacity. They slip when the torque exceeds the
capacity while the slip goes on, with tau = &plusmn; T(|w|) of slipping plates, and stick again when the slip passes
zero. phi_lock is a discrete variable, chosen then so that the torque stays what it was: the plates are wound up by
capacity/c. No state is added.</p>
</html>"));
end ElasticClutch;
