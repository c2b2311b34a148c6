within Mechanics.Translational.Interfaces;
partial model PartialCompliantWithSpeed "Massless connection whose law depends on the relative speed"
  extends PartialCompliant;
  Units.Velocity v_rel(start = 0) "Speed of flange_b relative to flange_a";
equation
  // Relative speed
  v_rel = der(s_rel);
  annotation(Documentation(info = "<html>
<p>v_rel = d s_rel / dt. The extending model gives the law for f.</p>
</html>"));
end PartialCompliantWithSpeed;
