within Hydraulics.Interfaces;
partial model PartialFeedback "Pressure that acts on a land of a spool"
  replaceable package Oil = Media.OilDexronVI constrainedby Media.PartialOil "Oil whose data are the default"
    annotation(choicesAllMatching = true);
  parameter Media.Fluid fluid = Oil.data "Oil";
  parameter Units.AbsolutePressure p_start = Constants.p_atmosphere "Proposed initial pressure";
  parameter Types.Direction pushes = Types.Direction.Positive "Direction in which the pressure pushes the spool";
  parameter Units.Area A "Area of the land";
  parameter Units.Volume V_0 = 1e-6 "Volume of the chamber at position 0, where there is one";
  parameter Units.Diameter d_orifice = 1e-3 "Orifice in front of the chamber, where there is one";
  Port port "Pressure";
  Mechanics.Translational.Interfaces.Flange flange "Spool";
  Mechanics.Units.Mass m "Mass of oil and air in the chamber";
  annotation(Documentation(info = "<html>
<p>The extending model says what oil stands in front of the land.</p>
</html>"));
end PartialFeedback;
