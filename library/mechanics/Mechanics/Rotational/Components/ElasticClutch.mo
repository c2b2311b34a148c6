within Mechanics.Rotational.Components;
model ElasticClutch "Friction clutch that sticks as a spring and damper up to its capacity"
  extends Interfaces.PartialFriction;
  parameter Units.Length thickness = 2e-3 "Thickness of the plates; nominal value of the study (1 to 4 mm)";
  parameter Units.TorsionalModulus c_thickness = 2.5e7
    "Stiffness over thickness; chosen: 25 kN.m/rad per millimetre, plates with paper linings on splines";
  parameter Units.RotationalSpringConstant c(min = 1e-6) = c_thickness*thickness "Stiffness of the sticking plates";
  parameter Units.RotationalDampingConstant d = 100
    "Damping of the sticking plates; chosen: loss factor 0.4 at the 30 Hz of a driveline, as of paper soaked with oil";
  parameter Units.AngularVelocity w_small(min = 0) = 0.01
    "Slip that counts as rest; chosen: far below any shift's, far above a solver's errors of fast shafts";
  Boolean stuck(start = true, fixed = true) "Whether the plates stick";
  discrete Units.Angle phi_lock(start = 0, fixed = true) "Relative angle at which the sticking plates carry no torque";
  Units.Angle windUp "Elastic angle of the plates, at most capacity/c";
protected
  constant Units.RotationalDampingConstant unitDamping = 1 "Makes a torque of a slip";
  Units.Torque breaking "Positive where sticking plates begin to slip";
  Units.AngularVelocity sticking "Positive where slipping plates stick";
  Units.Torque tau_stick "Torque of spring and damper without limit";
  discrete Real direction(start = 1, fixed = true, final unit = "1") "Sign of the slip";
equation
  // Spring and damper about the angle of lock
  tau_stick = c*(phi_rel - phi_lock) + d*w_rel;
  // Plates slip once the capacity is exceeded, and stick again when the slip has died; open ones never stick
  breaking = if pre(stuck) then noEvent(min(abs(tau_stick) - capacity, unitDamping*(sign(tau_stick)*w_rel - w_small)))
    else -1;
  sticking = if pre(stuck) then -1 else noEvent(if capacity > 0 then -pre(direction)*w_rel else -1);
  stuck = if pre(stuck) then not breaking > 0 else sticking > 0;
  when not stuck then
    direction = noEvent(if w_rel > 0 then 1 else -1);
  end when;
  when stuck then
    phi_lock = phi_rel - pre(direction)*capacity/c;
  end when;
  // Torque
  tau = if stuck then smooth(0, noEvent(max(-capacity, min(capacity, tau_stick)))) else direction*slipTorque;
  windUp = if stuck then smooth(0, noEvent(max(-capacity/c, min(capacity/c, phi_rel - phi_lock)))) else tau/c;
  // Energy
  lossPower = if stuck then (tau - c*windUp)*w_rel else tau*w_rel;
  annotation(Documentation(info = "<html>
<p>Sticking plates: tau = c (phi_rel - phi_lock) + d w_rel, at most the capacity. They slip when the torque exceeds the
capacity while the slip goes on, with tau = &plusmn; T(|w|) of slipping plates, and stick again when the slip passes
zero. phi_lock is a discrete variable, chosen then so that the torque stays what it was: the plates are wound up by
capacity/c. No state is added. Plates that slip stay wound up by tau/c. An open clutch is left alone: its slip may pass
zero as often as it will.</p>
</html>"));
end ElasticClutch;
