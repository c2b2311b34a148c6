within Mechanics.Rotational.Components;
model IdealBrake "Brake that either holds a shaft or leaves it free for the whole run"
  extends Interfaces.PartialOneFlange;
  parameter Boolean engaged = false "true: the shaft is held by the case, false: no torque"
    annotation(Evaluate = true);
  parameter Units.Angle phi_0 = 0 "Angle at which the shaft is held";
equation
  // Held by the case, or free
  if engaged then
    flange.phi = phi_0;
  else
    flange.tau = 0;
  end if;
  annotation(Documentation(info = "<html>
<p>engaged: phi = phi_0, with whatever torque that takes; otherwise tau = 0. The choice is structural: it changes
the number of degrees of freedom.</p>
</html>"));
end IdealBrake;
