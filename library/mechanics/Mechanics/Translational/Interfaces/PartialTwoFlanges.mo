within Mechanics.Translational.Interfaces;
partial model PartialTwoFlanges "Component with two flanges"
  Flange flange_a "Left end";
  Flange flange_b "Right end";
  annotation(Documentation(info = "<html>
<p>Base of everything between two rods.</p>
</html>"));
end PartialTwoFlanges;
