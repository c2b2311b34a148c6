within Hydraulics.Media;
record MineralVG32 "Mineral hydraulic oil of viscosity grade 32 at 40 degC"
  extends Fluid(
    p_ref = 101325,
    rho_ref = 858,
    nu = 32e-6,
    K_liquid = 1.6e9,
    airFraction = 0.005,
    p_dissolve = 1e6,
    p_gasMin = 1e3);
  annotation(Documentation(info = "<html>
<p>Where the numbers come from:</p>
<ul>
<li>nu: ISO 3448: grade VG 32 has 32 mm2/s at 40 degC in the middle of its class (28.8 to 35.2 mm2/s).</li>
<li>rho_ref: chosen: 873 kg/m3 at 15 degC, in the middle of what data sheets of mineral VG 32 oils give (860 to
880 kg/m3), less 0.07 % per kelvin over 25 K.</li>
<li>K_liquid: Merritt, Hydraulic Control Systems, 1967, section 2-3, gives 220,000 psi (1.5 GPa) for petroleum fluids
without air and lower values in practice; chosen: 1.6 GPa, secant at 40 degC and 100 bar.</li>
<li>airFraction: chosen: 0.5 %, an industrial tank in which the oil rests.</li>
<li>p_dissolve: chosen: half of what the transmission's oil has; mineral oil in equilibrium dissolves about 9 % of its
volume of air per bar (Bunsen coefficient 0.09), which is far more than 0.5 %.</li>
</ul>
</html>"));
end MineralVG32;
