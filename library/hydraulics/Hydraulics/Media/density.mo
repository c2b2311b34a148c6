within Hydraulics.Media;
function density "Density of oil with entrained air"
  input Units.AbsolutePressure p "Pressure";
  input Fluid fluid "Oil";
  output Units.Density rho "Density";
protected
  Units.AbsolutePressure p_gas "Pressure in the law of the air, positive for every p";
  Real liquid(unit = "1") "Volume of the liquid over the reference volume of both";
  Real gas(unit = "1") "Volume of the undissolved air over the reference volume of both";
algorithm
  p_gas := (p + sqrt(p^2 + fluid.p_gasMin^2))/2 + 1e-6*fluid.p_gasMin;
  liquid := (1 - fluid.airFraction)*exp(-(p - fluid.p_ref)/fluid.K_liquid);
  gas := fluid.airFraction*exp(-(p_gas - fluid.p_ref)/fluid.p_dissolve)*fluid.p_ref/p_gas;
  rho := fluid.rho_ref/(liquid + gas);
  annotation(
    Inline = true,
    smoothOrder = 10,
    Documentation(info = "<html>
<p>rho = rho_ref / w(p) with the volume of a fixed mass of oil and air over its volume at p_ref</p>
<p>w(p) = (1 - a) exp(-(p - p_ref) / K_liquid) + a exp(-(p_gas - p_ref) / p_dissolve) p_ref / p_gas.</p>
<p>The first term is liquid of constant bulk modulus, the second ideal gas at constant temperature of which a part
goes into solution as the pressure rises (Henry's law gives the slope at p_ref, -1/p_dissolve; the exponential
continues it without a kink at complete solution). The mass of the air stays in the oil when it dissolves. p_gas =
(p + sqrt(p<sup>2</sup> + p_gasMin<sup>2</sup>)) / 2 + 10<sup>-6</sup> p_gasMin keeps the law defined at every pressure, also in
floating-point numbers.</p>
<p>Source of the mixture law: for example H. E. Merritt, Hydraulic Control Systems, 1967, section 2-3.</p>
</html>"));
end density;
