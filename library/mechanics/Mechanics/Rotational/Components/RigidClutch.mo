within Mechanics.Rotational.Components;
model RigidClutch "Friction clutch whose sticking plates turn exactly as one"
  extends Interfaces.PartialFriction(
    phi_rel(stateSelect = StateSelect.prefer),
    w_rel(stateSelect = StateSelect.prefer));
  parameter Units.AngularVelocity w_small(min = 0) = 1e-6
    "Slip against the former direction that counts as reversal; chosen: above the rounding of fast shafts";
  Units.AngularVelocity slip "Slip, exactly zero while the plates stick";
  Units.AngularAcceleration a_rel "Acceleration of flange_b relative to flange_a";
  Boolean free "No normal force";
  Boolean startForward(start = false) "Plates begin to slip forwards";
  Boolean startBackward(start = false) "Plates begin to slip backwards";
  Boolean stuck(start = false) "Plates turn as one";
  Integer way(start = 3, fixed = true) "1 slips forwards, -1 backwards, 0 sticks, 2 free, 3 not known yet";
protected
  constant Units.AngularAcceleration a_unit = 1 "Acceleration along the path";
  constant Units.Torque tau_unit = 1 "Torque along the path";
  Units.Ratio s "Path: torque of plates that stick, then acceleration beyond it";
  Units.Ratio h "The same of plates that stuck before; 0 where it does not matter";
equation
  a_rel = der(w_rel);
  slip = if stuck then 0 else w_rel;
  // Which way the plates slip
  free = f_normal <= 0;
  h = if pre(way) == 0 then s else 0;
  startForward = h > capacity/tau_unit
    or pre(way) == -1 and w_rel > w_small or initial() and w_rel > 0;
  startBackward = h < -capacity/tau_unit
    or pre(way) == 1 and w_rel < -w_small or initial() and w_rel < 0;
  stuck = not free and not (pre(way) == 1 or startForward or pre(way) == -1 or startBackward);
  way = if free then 2
    elseif (pre(way) == 1 or pre(way) == 2 or startForward) and w_rel > 0 then 1
    elseif (pre(way) == -1 or pre(way) == 2 or startBackward) and w_rel < 0 then -1
    else 0;
  // Torque and acceleration along the path: both are given by s
  a_rel = a_unit*(
    if stuck then 0
    elseif free then s
    elseif pre(way) == 1 or startForward then s - capacity/tau_unit
    else s + capacity/tau_unit);
  tau = if stuck then tau_unit*s
    elseif free then 0
    elseif pre(way) == 1 or startForward then slipTorque
    else -slipTorque;
  // Energy
  lossPower = tau*slip;
  annotation(Documentation(info = "<html>
<p>The characteristic of torque over acceleration at zero slip is a curve with a parameter s: on its middle part the
acceleration is zero and the torque is s; beyond the capacity the torque is that of slipping plates and the acceleration is
what s exceeds the capacity by. Stuck plates hold whatever torque that takes, up to the capacity mu_0; they lock again when
the slip passes zero and the torque suffices. Several such clutches may close a loop of bodies: how their torques share
the load is then not determined by rigid bodies, and one of them must be elastic.</p>
<p>Source: M. Otter, H. Elmqvist and S. E. Mattsson, Hybrid modeling in Modelica based on the synchronous data flow
principle, IEEE Symposium on Computer-Aided Control System Design, 1999.</p>
</html>"));
end RigidClutch;
