within TenSpeed.Converter;
model TorqueConverter "Torque converter: hydrodynamic circuit, lock-up clutch and its cylinder"
  parameter Geometry geometry "Hydrodynamic circuit";
  replaceable package Oil = Hydraulics.Media.OilDexronVI constrainedby Hydraulics.Media.PartialOil
    "Oil whose data are the default" annotation(choicesAllMatching = true);
  parameter Hydraulics.Media.Fluid fluid = Oil.data "Oil of the cylinder";
  parameter Boolean hasCylinder = true "true: the lock-up clutch has its own cylinder, false: its force is an input"
    annotation(Evaluate = true);
  parameter Mechanics.Units.AngularVelocity w_p_start = 0 "Proposed initial speed of the impeller";
  parameter Mechanics.Units.AngularVelocity w_t_start = 0 "Proposed initial speed of the turbine";
  replaceable model Torus = TorusL1 constrainedby PartialTorus "Level of the hydrodynamic circuit"
    annotation(choicesAllMatching = true);
  Shaft impeller "Driven by the engine";
  Shaft turbine "Drives the gearbox";
  Hydraulics.Interfaces.Port port if hasCylinder "Pressure of the lock-up clutch, upstream of its feed orifice";
  Signals.Interfaces.RealInput lockupForce(unit = "N") if not hasCylinder "Normal force of the lock-up clutch";
  Torus torus(final geometry = geometry, final w_p_start = w_p_start, final w_t_start = w_t_start) "Hydrodynamic circuit";
  LockupClutch lockup "Lock-up clutch";
  Hydraulics.Components.ClutchCylinder cylinder(final fluid = fluid, A = 200e-4) if hasCylinder "Of the lock-up clutch";
protected
  Signals.Sources.Constant still(k = 0) if hasCylinder "The cylinder's oil turns with both sides of the piston";
equation
  // Both paths in parallel
  connect(impeller, torus.impeller);
  connect(turbine, torus.turbine);
  connect(impeller, lockup.impeller);
  connect(turbine, lockup.turbine);
  // Normal force
  connect(port, cylinder.port);
  connect(still.y, cylinder.w);
  connect(cylinder.f_normal, lockup.f_normal);
  connect(lockupForce, lockup.f_normal);
  annotation(Documentation(info = "<html>
<p>States: those of the circuit's level, the wind-up of the lock-up clutch, and with the cylinder its piston's position
and speed and its pressure.</p>
</html>"));
end TorqueConverter;
