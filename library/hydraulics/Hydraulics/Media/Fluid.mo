within Hydraulics.Media;
record Fluid "Parameters of an oil with entrained air at constant temperature"
  Units.AbsolutePressure p_ref "Reference pressure";
  Units.Density rho_ref "Density of oil and air together at the reference pressure";
  Units.KinematicViscosity nu "Kinematic viscosity";
  Units.BulkModulus K_liquid "Bulk modulus of the oil without air";
  Units.Fraction airFraction "Undissolved air at the reference pressure, as a fraction of the volume";
  Units.PressureDifference p_dissolve "Rise of pressure over which the undissolved air falls by the factor e";
  Units.AbsolutePressure p_gasMin "Pressure below which the law of the air is bent so that it holds for every pressure";
  annotation(Documentation(info = "<html>
<p>No value has a default here; see <code>DexronVI</code>.</p>
</html>"));
end Fluid;
