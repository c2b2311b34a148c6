within Mechanics.Rotational.Interfaces;
partial model PartialTwoFlanges "Component with two flanges"
  Flange flange_a "Left shaft";
  Flange flange_b "Right shaft";
  annotation(Documentation(info = "<html>
<p>Base of everything between two shafts.</p>
</html>"));
end PartialTwoFlanges;
