within Mechanics.Translational.Components;
model Spring "Linear spring"
  extends Interfaces.PartialCompliant;
  parameter Units.TranslationalSpringConstant c "Stiffness";
  parameter Units.Length s_rel0 = 0 "Relative position without force";
equation
  // Hooke's law
  f = c*(s_rel - s_rel0);
  annotation(Documentation(info = "<html>
<p>f = c (s_rel - s_rel0).</p>
</html>"));
end Spring;
