within Electrical.Components;
model Resistor "Ohmic resistance"
  extends Interfaces.PartialTwoPin;
  parameter Units.Resistance R "Resistance";
equation
  // Ohm's law
  v = R*i;
  annotation(Documentation(info = "<html>
<p>v = R i.</p>
</html>"));
end Resistor;
