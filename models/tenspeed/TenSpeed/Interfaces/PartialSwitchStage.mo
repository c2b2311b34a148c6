within TenSpeed.Interfaces;
partial model PartialSwitchStage "Spool of a switch valve, or what stands for it"
  replaceable package Oil = Hydraulics.Media.OilDexronVI constrainedby Hydraulics.Media.PartialOil
    "Oil whose data are the default" annotation(choicesAllMatching = true);
  parameter Hydraulics.Media.Fluid fluid = Oil.data "Oil";
  parameter Hydraulics.Units.AbsolutePressure p_start = 101325 "Proposed initial pressures";
  parameter Mechanics.Units.Mass m "Mass of the spool";
  parameter Mechanics.Units.TranslationalSpringConstant c "Stiffness of the spring";
  parameter Mechanics.Units.TranslationalDampingConstant d "Damping";
  parameter Mechanics.Units.Force F_preload "Force of the spring at position 0";
  parameter Mechanics.Units.Position s_max "Stroke";
  parameter Hydraulics.Units.Area A_pilot "Land of the pilot pressure";
  parameter Hydraulics.Units.Volume V_outlet "Volume of the outlet";
  Hydraulics.Interfaces.Port supply "Supply";
  Hydraulics.Interfaces.Port drain "Drain";
  Hydraulics.Interfaces.Port outlet "Outlet";
  Hydraulics.Interfaces.Port pilot "Pilot pressure";
  Mechanics.Translational.Interfaces.Flange flange "Spool, for further edges";
  Mechanics.Units.Mass m_oil "Mass of oil and air inside";
  annotation(Documentation(info = "<html>
<p>Parameters that a level does not need have no effect there.</p>
</html>"));
end PartialSwitchStage;
