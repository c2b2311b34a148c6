within Mechanics.Translational.Interfaces;
partial model PartialCompliant "Massless connection of two rods that may move against each other"
  extends PartialTwoFlanges;
  Units.Length s_rel(start = 0) "Position of flange_b relative to flange_a";
  Units.Force f "Force into flange_b";
equation
  // Relative position
  s_rel = flange_b.s - flange_a.s;
  // Equilibrium without mass
  flange_b.f = f;
  flange_a.f = -f;
  annotation(Documentation(info = "<html>
<p>s_rel = s_b - s_a; f_b = f = -f_a. The extending model gives the law for f.</p>
</html>"));
end PartialCompliant;
