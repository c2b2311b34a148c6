within Mechanics.Rotational.Components;
model Spring "Linear torsional spring"
  extends Interfaces.PartialCompliant;
  parameter Units.RotationalSpringConstant c "Stiffness";
  parameter Units.Angle phi_rel0 = 0 "Relative angle without torque";
equation
  // Hooke's law
  tau = c*(phi_rel - phi_rel0);
  annotation(Documentation(info = "<html>
<p>tau = c (phi_rel - phi_rel0).</p>
</html>"));
end Spring;
