within Mechanics.Rotational.Interfaces;
partial model PartialCompliantWithSpeed "Massless connection whose law depends on the relative speed"
  extends PartialCompliant;
  Units.AngularVelocity w_rel(start = 0) "Speed of flange_b relative to flange_a";
equation
  // Relative speed
  w_rel = der(phi_rel);
  annotation(Documentation(info = "<html>
<p>w_rel = d phi_rel / dt. The extending model gives the law for tau.</p>
</html>"));
end PartialCompliantWithSpeed;
