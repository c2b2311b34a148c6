within TenSpeed.Converter;
record Geometry "Parameters of the hydrodynamic circuit"
  // Blade rings
  parameter Mechanics.Units.Length R_p = 0.1105 "Exit radius of the impeller";
  parameter Mechanics.Units.Length R_t = 0.0668 "Exit radius of the turbine";
  parameter Mechanics.Units.Length R_s = 0.0605 "Exit radius of the stator";
  parameter Mechanics.Units.Area A = 0.0097 "Flow area";
  parameter Mechanics.Units.Angle a_p = 18.01*degree "Exit angle of the impeller";
  parameter Mechanics.Units.Angle a_t = -59.04*degree "Exit angle of the turbine";
  parameter Mechanics.Units.Angle a_s = 59.54*degree "Exit angle of the stator";
  parameter Mechanics.Units.Angle b_p = 0 "Entry angle of the impeller";
  parameter Mechanics.Units.Angle b_t = 40*degree "Entry angle of the turbine";
  parameter Mechanics.Units.Angle b_s = 0 "Entry angle of the stator";
  // Inertia
  parameter Mechanics.Units.Area S_p = -0.001 "Shape factor of the impeller";
  parameter Mechanics.Units.Area S_t = -0.00002 "Shape factor of the turbine";
  parameter Mechanics.Units.Area S_s = 0.002 "Shape factor of the stator";
  parameter Mechanics.Units.Length L_f = 0.28 "Length of the fluid's path";
  parameter Mechanics.Units.Inertia I_p = 0.092 "Inertia of the impeller with its oil";
  parameter Mechanics.Units.Inertia I_t = 0.026 "Inertia of the turbine with its oil";
  parameter Mechanics.Units.Inertia I_s = 0.012 "Inertia of the stator with its oil";
  parameter Mechanics.Units.Density rho = 840 "Density of the oil";
  // Losses
  parameter Mechanics.Units.Ratio C_p = 1 "Shock loss factor of the impeller";
  parameter Mechanics.Units.Ratio C_t = 1 "Shock loss factor of the turbine";
  parameter Mechanics.Units.Ratio C_s = 1 "Shock loss factor of the stator";
  parameter Mechanics.Units.Ratio f = 0.2 "Friction factor of the walls";
  // Small flow
  parameter Hydraulics.Units.VolumeFlowRate Q_0(min = 1e-9) = 1e-4
    "Flow within which both directions blend; chosen: 0.1 % of the flow at stall at 200 rad/s";
  parameter Mechanics.Units.RotationalDampingConstant d_s(min = 1e-9) = 1e-6
    "Drag of the stator's bearing; chosen: 0.2 N.mm at 200 rad/s, which no steady figure feels";
  annotation(Documentation(info = "<html>
<p>Defaults: a converter of the 1980s as published; its entry angles are chosen. Torques in steady state are
proportional to rho and to the square of the speeds.</p>
</html>"));
end Geometry;
