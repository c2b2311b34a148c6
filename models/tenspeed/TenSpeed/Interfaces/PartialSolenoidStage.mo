within TenSpeed.Interfaces;
partial model PartialSolenoidStage "Hydraulic part of a solenoid valve"
  replaceable package Oil = Hydraulics.Media.OilDexronVI constrainedby Hydraulics.Media.PartialOil
    "Oil whose data are the default" annotation(choicesAllMatching = true);
  parameter Hydraulics.Media.Fluid fluid = Oil.data "Oil";
  parameter Hydraulics.Units.AbsolutePressure p_start = 101325 "Proposed initial pressures";
  parameter Mechanics.Units.Mass m "Mass of plunger and spool";
  parameter Mechanics.Units.TranslationalSpringConstant c "Stiffness of the spring";
  parameter Mechanics.Units.TranslationalDampingConstant d "Damping";
  parameter Mechanics.Units.Force F_preload "Force of the spring at position 0";
  parameter Electrical.Units.ForceConstant k_F "Force per current";
  parameter Hydraulics.Units.Volume V_outlet "Volume of the outlet";
  Hydraulics.Interfaces.Port supply "Supply";
  Hydraulics.Interfaces.Port drain "Drain";
  Hydraulics.Interfaces.Port outlet "Outlet";
  Mechanics.Translational.Interfaces.Flange flange "Plunger";
  Signals.Interfaces.RealInput i(unit = "A") "Current in the coil";
  Mechanics.Units.Position s "Position of the spool, 0 where there is none";
  Mechanics.Units.Mass m_oil "Mass of oil and air inside";
  annotation(Documentation(info = "<html>
<p>A stage with a spool is moved by the plunger, a map reads the current. Parameters that a level does not need have no
effect there.</p>
</html>"));
end PartialSolenoidStage;
