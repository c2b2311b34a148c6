within TenSpeed.Converter;
partial model PartialTorus "Hydrodynamic circuit between impeller and turbine"
  parameter Geometry geometry "Geometry, inertias and losses";
  parameter Mechanics.Units.AngularVelocity w_p_start = 0 "Proposed initial speed of the impeller";
  parameter Mechanics.Units.AngularVelocity w_t_start = 0 "Proposed initial speed of the turbine";
  parameter Hydraulics.Units.VolumeFlowRate Q_start = 0 "Proposed initial flow";
  Shaft impeller "Driven by the engine";
  Shaft turbine "Drives the gearbox";
  annotation(Documentation(info = "<html>
<p>What all levels have in common: two shafts and the parameters.</p>
</html>"));
end PartialTorus;
