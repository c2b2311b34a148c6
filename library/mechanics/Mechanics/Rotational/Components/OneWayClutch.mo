within Mechanics.Rotational.Components;
model OneWayClutch "Clutch that lets one shaft overtake another in one direction only"
  extends Interfaces.PartialCompliantWithSpeed;
  parameter Units.AngularVelocity w_lock = 0.025 "Speed below which it locks; chosen: as the two-way clutch";
  parameter Units.RotationalDampingConstant b = 2000 "Damping of the locked clutch; chosen: as the two-way clutch";
  parameter Units.RotationalSpringConstant k = 50 "Stiffness of the locked clutch; chosen: as the two-way clutch";
  Boolean locked(start = true) "Whether it holds against backward motion";
  discrete Units.Angle phi_lock(start = 0) "Relative angle at which it locked";
  Units.Power lossPower "Power turned into heat or kept in the spring";
equation
  // Lock
  locked = w_rel < w_lock;
  when locked then
    phi_lock = phi_rel;
  end when;
  // Torque
  tau = if locked then smooth(0, noEvent(min(b*w_rel + k*(phi_rel - phi_lock), 0))) else 0;
  // Energy
  lossPower = tau*w_rel;
  annotation(Documentation(info = "<html>
<p>Free while flange_b is faster than flange_a by w_lock. Locked, the torque on flange_b is -b w_rel - k (phi_rel -
phi_lock), never negative, with the angle phi_lock at which w_rel fell through w_lock: a discrete variable, so nothing
winds up in free-wheeling and no state is added. Under load the locked clutch creeps with -T/b.</p>
</html>"));
end OneWayClutch;
