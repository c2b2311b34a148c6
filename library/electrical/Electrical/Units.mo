within Electrical;
package Units "Physical quantities of electricity, all in SI units"
  type Voltage = Real(final quantity = "ElectricPotential", final unit = "V") "Voltage";
  type Current = Real(final quantity = "ElectricCurrent", final unit = "A") "Current";
  type Resistance = Real(final quantity = "Resistance", final unit = "Ohm") "Resistance";
  type Inductance = Real(final quantity = "Inductance", final unit = "H", min = 0) "Inductance";
  type ForceConstant = Real(final quantity = "ForceConstant", final unit = "N/A") "Force per current";
  annotation(Documentation(info = "<html>
<p>Quantity and unit are final. Mechanical quantities come from <code>Mechanics.Units</code>.</p>
</html>"));
end Units;
