within Hydraulics.Media;
function bulkModulus "Effective bulk modulus of oil with entrained air"
  input Units.AbsolutePressure p "Pressure";
  input Fluid fluid "Oil";
  output Units.BulkModulus K "Density over its derivative by pressure";
protected
  Units.AbsolutePressure p_root "Smooth magnitude of the pressure";
  Units.AbsolutePressure p_gas "Pressure in the law of the air, positive for every p";
  Real liquid(unit = "1") "Volume of the liquid over the reference volume of both";
  Real gas(unit = "1") "Volume of the undissolved air over the reference volume of both";
algorithm
  p_root := sqrt(p^2 + fluid.p_gasMin^2);
  p_gas := (p + p_root)/2 + 1e-6*fluid.p_gasMin;
  liquid := (1 - fluid.airFraction)*exp(-(p - fluid.p_ref)/fluid.K_liquid);
  gas := fluid.airFraction*exp(-(p_gas - fluid.p_ref)/fluid.p_dissolve)*fluid.p_ref/p_gas;
  K := (liquid + gas)/(liquid/fluid.K_liquid + gas*(1/fluid.p_dissolve + 1/p_gas)*(1 + p/p_root)/2);
  annotation(
    Inline = true,
    smoothOrder = 10,
    Documentation(info = "<html>
<p>K = rho dp/drho of <code>density</code>, in closed form: w / (-dw/dp) with d p_gas/dp = (1 + p / sqrt(p<sup>2</sup>
+ p_gasMin<sup>2</sup>)) / 2.</p>
</html>"));
end bulkModulus;
