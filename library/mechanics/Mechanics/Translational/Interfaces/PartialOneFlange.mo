within Mechanics.Translational.Interfaces;
partial model PartialOneFlange "Component with one flange"
  Flange flange "Rod";
  annotation(Documentation(info = "<html>
<p>Base of everything that stands between one rod and the case.</p>
</html>"));
end PartialOneFlange;
