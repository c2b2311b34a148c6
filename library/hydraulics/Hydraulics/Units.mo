within Hydraulics;
package Units "Physical quantities of hydraulics, all in SI units"
  type AbsolutePressure = Real(
    final quantity = "Pressure",
    final unit = "Pa",
    displayUnit = "bar",
    min = 0,
    nominal = 1e5) "Absolute pressure";
  type PressureDifference = Real(
    final quantity = "Pressure",
    final unit = "Pa",
    displayUnit = "bar",
    nominal = 1e5) "Pressure difference";
  type VolumeFlowRate = Real(
    final quantity = "VolumeFlowRate",
    final unit = "m3/s",
    displayUnit = "l/min",
    nominal = 1e-4) "Volume flow rate";
  type MassFlowRate = Real(final quantity = "MassFlowRate", final unit = "kg/s", nominal = 0.1) "Mass flow rate";
  type Density = Real(final quantity = "Density", final unit = "kg/m3", min = 0, nominal = 1e3) "Density";
  type KinematicViscosity = Real(
    final quantity = "KinematicViscosity",
    final unit = "m2/s",
    displayUnit = "mm2/s",
    min = 0) "Kinematic viscosity";
  type BulkModulus = Real(final quantity = "BulkModulus", final unit = "Pa", min = 0, nominal = 1e9)
    "Bulk modulus";
  type Volume = Real(final quantity = "Volume", final unit = "m3", displayUnit = "l", nominal = 1e-4) "Volume";
  type Area = Real(final quantity = "Area", final unit = "m2", displayUnit = "cm2", nominal = 1e-4) "Area";
  type Diameter = Real(final quantity = "Length", final unit = "m", displayUnit = "mm", min = 0) "Diameter";
  type Fraction = Real(final quantity = "Fraction", final unit = "1", min = 0, max = 1) "Fraction of a whole";
  type Coefficient = Real(final quantity = "Coefficient", final unit = "1", min = 0) "Dimensionless coefficient";
  annotation(Documentation(info = "<html>
<p>Quantity and unit are final. Mechanical quantities come from <code>Mechanics.Units</code>.</p>
</html>"));
end Units;
