within TenSpeed.Interfaces;
partial model PartialTwoWayClutchStage "Level of the two-way-clutch valve"
  replaceable package Oil = Hydraulics.Media.OilDexronVI constrainedby Hydraulics.Media.PartialOil
    "Oil whose data are the default" annotation(choicesAllMatching = true);
  parameter Hydraulics.Media.Fluid fluid = Oil.data "Oil";
  parameter Hydraulics.Units.AbsolutePressure p_start = 101325 "Proposed initial pressures";
  parameter Mechanics.Units.Mass m "Mass of the spool and of what it moves";
  parameter Mechanics.Units.TranslationalDampingConstant d "Damping";
  parameter Mechanics.Units.Length stroke "Distance of the two positions";
  parameter Hydraulics.Units.Area A "Land of each chamber";
  parameter Mechanics.Units.Length hump "Height of the detents' cam half-way";
  parameter Mechanics.Units.Force F_detent "Force of each detent's spring at rest";
  parameter Mechanics.Units.TranslationalSpringConstant c_detent "Stiffness of each detent's spring";
  Hydraulics.Interfaces.Port drive[2] "Pressures that push to drive";
  Hydraulics.Interfaces.Port reverse[2] "Pressures that push to reverse";
  Mechanics.Units.Position s "Position: 0 in reverse, stroke in drive";
  Mechanics.Units.Mass m_oil "Mass of oil and air inside";
  annotation(Documentation(info = "<html>
<p>Parameters that a level does not need have no effect there.</p>
</html>"));
end PartialTwoWayClutchStage;
