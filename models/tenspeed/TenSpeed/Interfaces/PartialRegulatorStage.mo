within TenSpeed.Interfaces;
partial model PartialRegulatorStage "Level of a regulator's spool, or what stands for it"
  replaceable package Oil = Hydraulics.Media.OilDexronVI constrainedby Hydraulics.Media.PartialOil
    "Oil whose data are the default" annotation(choicesAllMatching = true);
  parameter Hydraulics.Media.Fluid fluid = Oil.data "Oil";
  parameter Hydraulics.Units.AbsolutePressure p_start = 101325 "Proposed initial pressures";
  parameter Mechanics.Units.Mass m "Mass of the spool";
  parameter Mechanics.Units.TranslationalDampingConstant d "Damping";
  Mechanics.Units.Position s "Position of the spool, 0 where there is none";
  Mechanics.Units.Mass m_oil "Mass of oil and air inside";
  annotation(Documentation(info = "<html>
<p>Parameters that a level does not need have no effect there.</p>
</html>"));
end PartialRegulatorStage;
