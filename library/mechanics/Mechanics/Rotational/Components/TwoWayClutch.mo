within Mechanics.Rotational.Components;
model TwoWayClutch "One-way clutch between a shaft and the case that can be locked in both directions"
  extends Interfaces.PartialOneFlange;
  parameter Units.AngularVelocity w_lock = 0.025 "Speed below which it locks";
  parameter Units.RotationalDampingConstant b = 2000 "Damping of the locked clutch";
  parameter Units.RotationalSpringConstant k = 50 "Stiffness of the locked clutch";
  Signals.Interfaces.BooleanInput lockBothWays "true: locked in both directions";
  Units.Angle phi "Angle of the shaft";
  Units.AngularVelocity w(start = 0) "Speed of the shaft, free where positive";
  Units.Torque tau "Torque on the shaft";
  Boolean locked(start = true) "Whether it holds against backward motion";
  discrete Units.Angle phi_lock(start = 0) "Angle at which it locked";
  Units.Power lossPower "Power turned into heat or kept in the spring";
protected
  Units.Torque holding "Torque of the lock without limit";
equation
  // Motion
  phi = flange.phi;
  w = der(phi);
  // Lock
  locked = w < w_lock;
  when {locked, lockBothWays} then
    phi_lock = phi;
  end when;
  // Torque
  holding = -b*w - k*(phi - phi_lock);
  tau = if lockBothWays then holding elseif locked then smooth(0, noEvent(max(holding, 0))) else 0;
  flange.tau = -tau;
  // Energy
  lossPower = -tau*w;
  annotation(Documentation(info = "<html>
<p>Free while w &gt; w_lock. Locked, tau = -b w - k (phi - phi_lock), never negative, with the angle phi_lock at which w
fell through w_lock: a discrete variable, so that nothing winds up in free-wheeling and no state is added. Locked both
ways: the same law in both directions.</p>
</html>"));
end TwoWayClutch;
