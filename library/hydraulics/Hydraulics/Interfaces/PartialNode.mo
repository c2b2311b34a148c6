within Hydraulics.Interfaces;
partial model PartialNode "Where several lines meet at one pressure"
  replaceable package Oil = Media.OilDexronVI constrainedby Media.PartialOil "Oil whose data are the default"
    annotation(choicesAllMatching = true);
  parameter Media.Fluid fluid = Oil.data "Oil";
  parameter Units.AbsolutePressure p_start = Constants.p_atmosphere "Proposed initial pressure";
  parameter Integer n(min = 1) = 2 "Number of ports";
  parameter Units.Volume V_0 "Volume, where oil is stored";
  Port port[n] "Ports, all at one pressure";
  Units.AbsolutePressure p(start = p_start) "Pressure";
  Mechanics.Units.Mass m "Mass of oil and air";
  annotation(Documentation(info = "<html>
<p>What <code>Components.Volume</code>, which stores oil, and <code>Components.Junction</code>, which does not, have in
common.</p>
</html>"));
end PartialNode;
