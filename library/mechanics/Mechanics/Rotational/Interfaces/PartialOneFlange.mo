within Mechanics.Rotational.Interfaces;
partial model PartialOneFlange "Component with one flange"
  Flange flange "Shaft";
  annotation(Documentation(info = "<html>
<p>Base of everything that stands between one shaft and the case.</p>
</html>"));
end PartialOneFlange;
