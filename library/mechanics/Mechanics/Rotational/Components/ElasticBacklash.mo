within Mechanics.Rotational.Components;
model ElasticBacklash "Elastic, damped coupling of two shafts with play"
  extends Interfaces.PartialCompliantWithSpeed;
  parameter Units.RotationalSpringConstant c "Stiffness in contact";
  parameter Units.RotationalDampingConstant d = 0 "Damping in contact";
  parameter Units.Angle b(min = 0) = 0 "Total play";
  Units.Power lossPower "Power turned into heat";
  Units.Energy storedEnergy "Energy of the spring";
protected
  Units.Torque tau_c "Elastic part of the torque";
equation
  // Contact on one side, on the other, or on none
  tau = Functions.backlashTorque(phi_rel, w_rel, b, c, d);
  // Energy
  tau_c = Functions.backlashTorque(phi_rel, 0, b, c, 0);
  lossPower = (tau - tau_c)*w_rel;
  storedEnergy = smooth(1, noEvent(c/2*max(0, abs(phi_rel) - b/2)^2));
  annotation(Documentation(info = "<html>
<p>tau = 0 within the play, c (phi_rel &plusmn; b/2) plus damping beyond it, never pulling a contact together. The
torque is continuous and makes no event.</p>
</html>"));
end ElasticBacklash;
