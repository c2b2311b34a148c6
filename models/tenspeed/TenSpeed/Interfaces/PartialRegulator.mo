within TenSpeed.Interfaces;
partial model PartialRegulator "What the valves of the regulation circuit have in common"
  replaceable package Oil = Hydraulics.Media.OilDexronVI constrainedby Hydraulics.Media.PartialOil
    "Oil whose data are the default" annotation(choicesAllMatching = true);
  parameter Hydraulics.Media.Fluid fluid = Oil.data "Oil";
  parameter Hydraulics.Units.AbsolutePressure p_start = 101325 "Proposed initial pressures";
  parameter Mechanics.Units.Mass m = 1e-3 "Mass of the spool; nominal value of the study";
  parameter Real dampingFactor(unit = "1") = 0.05 "Damping factor; nominal value of the study";
  parameter Mechanics.Units.TranslationalDampingConstant d_ref = 1000
    "Damping at damping factor 1; chosen: reads the factor in N s/mm, oil in narrow clearances";
  final parameter Mechanics.Units.TranslationalDampingConstant d = dampingFactor*d_ref "Damping";
  Mechanics.Units.Position s "Position of the spool, 0 where there is none";
  Mechanics.Units.Mass m_oil "Mass of oil and air inside";
  annotation(Documentation(info = "<html>
<p>Damping proportional to the velocity with a coefficient of its own: relative to the spring alone (some N/mm on 1 g) a
factor of 0.05 would leave the spool practically undamped and every loop with feedback unstable.</p>
</html>"));
end PartialRegulator;
