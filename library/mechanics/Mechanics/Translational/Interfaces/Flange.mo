within Mechanics.Translational.Interfaces;
connector Flange "End of a rod"
  Units.Position s "Absolute position";
  flow Units.Force f "Force into the component";
  annotation(Documentation(info = "<html>
<p>Connected flanges have the same position and their forces sum to zero. Names as in the Modelica Standard
Library.</p>
</html>"));
end Flange;
