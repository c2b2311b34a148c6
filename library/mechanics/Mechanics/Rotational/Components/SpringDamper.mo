within Mechanics.Rotational.Components;
model SpringDamper "Linear torsional spring and damper in parallel"
  extends Interfaces.PartialCompliantWithSpeed;
  parameter Units.RotationalSpringConstant c "Stiffness";
  parameter Units.RotationalDampingConstant d "Damping";
  parameter Units.Angle phi_rel0 = 0 "Relative angle without elastic torque";
  Units.Torque tau_c "Elastic torque";
  Units.Torque tau_d "Damping torque";
  Units.Power lossPower "Power turned into heat";
equation
  // Hooke's law
  tau_c = c*(phi_rel - phi_rel0);
  // Viscous friction
  tau_d = d*w_rel;
  // Both in parallel
  tau = tau_c + tau_d;
  // Energy
  lossPower = tau_d*w_rel;
  annotation(Documentation(info = "<html>
<p>tau = c (phi_rel - phi_rel0) + d w_rel.</p>
</html>"));
end SpringDamper;
