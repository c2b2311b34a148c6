within Mechanics.Rotational.Components;
model IdealEngagement "Clutch that is either rigid or open for the whole run"
  extends Interfaces.PartialTwoFlanges;
  parameter Boolean engaged = false "true: both shafts turn as one, false: no torque"
    annotation(Evaluate = true);
  Units.Torque tau "Torque into flange_b";
equation
  // Rigid coupling, or none
  if engaged then
    flange_a.phi = flange_b.phi;
  else
    tau = 0;
  end if;
  // Equilibrium without mass
  flange_b.tau = tau;
  flange_a.tau = -tau;
  annotation(Documentation(info = "<html>
<p>engaged: phi_a = phi_b, with whatever torque that takes; otherwise tau = 0. The choice is structural: it changes
the number of degrees of freedom.</p>
</html>"));
end IdealEngagement;
