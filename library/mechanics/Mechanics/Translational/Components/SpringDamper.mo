within Mechanics.Translational.Components;
model SpringDamper "Linear spring and damper in parallel"
  extends Interfaces.PartialCompliantWithSpeed;
  parameter Units.TranslationalSpringConstant c "Stiffness";
  parameter Units.TranslationalDampingConstant d "Damping";
  parameter Units.Length s_rel0 = 0 "Relative position without elastic force";
  Units.Force f_c "Elastic force";
  Units.Force f_d "Damping force";
  Units.Power lossPower "Power turned into heat";
equation
  // Hooke's law
  f_c = c*(s_rel - s_rel0);
  // Viscous friction
  f_d = d*v_rel;
  // Both in parallel
  f = f_c + f_d;
  // Energy
  lossPower = f_d*v_rel;
  annotation(Documentation(info = "<html>
<p>f = c (s_rel - s_rel0) + d v_rel.</p>
</html>"));
end SpringDamper;
