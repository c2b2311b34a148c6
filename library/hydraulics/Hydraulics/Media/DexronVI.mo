within Hydraulics.Media;
record DexronVI "Automatic transmission fluid like Dexron VI at 40 degC"
  extends Fluid(
    p_ref = 101325,
    rho_ref = 830,
    nu = 29.6e-6,
    K_liquid = 1.5e9,
    airFraction = 0.01,
    p_dissolve = 2e6,
    p_gasMin = 1e3);
  annotation(Documentation(info = "<html>
<p>Where the numbers come from:</p>
<ul>
<li>p_ref: standard atmosphere.</li>
<li>rho_ref: chosen: 845 kg/m3 at 15 degC, usual for these fluids, less 0.07 % per kelvin of thermal expansion over
25 K.</li>
<li>nu: General Motors' specification GMW16444 (before: GMN10060) allows at most 6.4 mm2/s at 100 degC; chosen: 6 mm2/s
there and about 30 mm2/s at 40 degC, as fluids of this class have.</li>
<li>K_liquid: Merritt, Hydraulic Control Systems, 1967, section 2-3: 220,000 psi (1.5 GPa) for petroleum fluids without
air.</li>
<li>airFraction: chosen: 1 %, a moderately aerated sump.</li>
<li>p_dissolve: chosen: a tenth of the air is left at 46 bar; dissolution at equilibrium would be much faster, but
the oil does not rest that long at any pressure.</li>
<li>p_gasMin: chosen: 1 % of the atmosphere, so that nothing above 0.1 bar is affected by more than 1 %.</li>
</ul>
</html>"));
end DexronVI;
