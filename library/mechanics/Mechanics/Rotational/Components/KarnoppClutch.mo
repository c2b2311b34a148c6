within Mechanics.Rotational.Components;
model KarnoppClutch "Friction clutch that sticks within a dead zone of slip"
  extends Interfaces.PartialFriction;
  parameter Units.AngularVelocity w_dead(min = 1e-12) = 0.01 "Half of the dead zone; chosen: far below any shift's slip";
  Units.AngularAcceleration a_rel "Acceleration of flange_b relative to flange_a";
  Boolean slow "The slip is within the dead zone";
  Boolean forward "Plates slip forwards";
  Boolean backward "Plates slip backwards";
  Boolean stuck "Plates keep their slip, which is within the dead zone";
protected
  constant Units.AngularAcceleration a_unit = 1 "Acceleration along the path";
  constant Units.Torque tau_unit = 1 "Torque along the path";
  Units.Ratio s "Path: torque of plates that stick, then acceleration beyond it";
equation
  a_rel = der(w_rel);
  // Within the dead zone the torque decides, outside it the slip
  slow = w_rel < w_dead and w_rel > -w_dead;
  forward = if slow then s > capacity/tau_unit else w_rel > 0;
  backward = if slow then s < -capacity/tau_unit else w_rel < 0;
  stuck = not (forward or backward);
  // Torque and acceleration along the path
  a_rel = a_unit*(if forward then s - capacity/tau_unit elseif backward then s + capacity/tau_unit else 0);
  tau = if forward then slipTorque elseif backward then -slipTorque else tau_unit*s;
  // Energy
  lossPower = tau*w_rel;
  annotation(Documentation(info = "<html>
<p>Where |w| &lt; w_dead the plates hold the torque that keeps their slip as it is, up to the capacity; else
tau = &plusmn; T(|w|). No zero of the slip has to be met: a slip below w_dead remains while they stick.</p>
<p>Source: D. Karnopp, Computer simulation of stick-slip friction in mechanical dynamic systems, Journal of Dynamic
Systems, Measurement and Control 107 (1985), 100-103.</p>
</html>"));
end KarnoppClutch;
