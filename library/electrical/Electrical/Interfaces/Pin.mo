within Electrical.Interfaces;
connector Pin "Electric terminal"
  Units.Voltage v "Potential";
  flow Units.Current i "Current into the component";
  annotation(Documentation(info = "<html>
<p>Connected pins have the same potential and their currents sum to zero. Names as in the Modelica Standard
Library.</p>
</html>"));
end Pin;
