within Hydraulics.Examples;
model FluidProperties "Density and bulk modulus over pressure are consistent"
  parameter Media.Fluid fluid = Media.DexronVI() "Oil";
  parameter Units.AbsolutePressure p_low = 2e4 "Pressure at time 0";
  parameter Real rate(unit = "Pa/s") = 2e6 "Rise of pressure";
  Units.AbsolutePressure p "Pressure";
  Units.Density rho "Density";
  Units.BulkModulus K "Bulk modulus";
  output Real error(unit = "1") "Relative difference of the slope of density and density over bulk modulus";
equation
  // Pressure rises in time
  p = p_low + rate*time;
  // Properties
  rho = Media.density(p, fluid);
  K = Media.bulkModulus(p, fluid);
  // K = rho dp/drho
  error = der(rho)*K/(rho*rate) - 1;
  annotation(
    experiment(StopTime = 1, Tolerance = 1e-8),
    Documentation(info = "<html>
<p>drho/dt = rho / K dp/dt must hold exactly.</p>
</html>"));
end FluidProperties;
