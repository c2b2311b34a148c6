within Mechanics.Rotational.Components;
model SmoothClutch "Friction clutch whose torque rises smoothly with slip and never sticks"
  extends Interfaces.PartialFriction;
  parameter Units.AngularVelocity w_0(min = 1e-9) = 0.1 "Slip at which three quarters of the torque are reached";
equation
  // Smooth friction
  tau = slipTorque*tanh(w_rel/w_0);
  // Energy
  lossPower = tau*w_rel;
  annotation(Documentation(info = "<html>
<p>tau = T(|w|) tanh(w / w_0) with the torque T of slipping plates. There is no event; under load the plates creep with
about w_0 atanh(tau / T).</p>
</html>"));
end SmoothClutch;
