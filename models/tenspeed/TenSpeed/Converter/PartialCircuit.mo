within TenSpeed.Converter;
partial model PartialCircuit "Circuit of oil through impeller, turbine and stator"
  extends PartialTorus;
  Mechanics.Units.AngularVelocity w_p(start = w_p_start, nominal = 100) "Speed of the impeller";
  Mechanics.Units.AngularVelocity w_t(start = w_t_start, nominal = 100) "Speed of the turbine";
  Mechanics.Units.AngularVelocity w_s(start = 0, nominal = 100) "Speed of the stator";
  Hydraulics.Units.VolumeFlowRate Q(start = Q_start, nominal = 1e-2) "Flow, positive from impeller to turbine to stator";
  Mechanics.Units.Torque tau_h[3] "Torques of impeller, turbine and stator on the oil in steady flow";
  Hydraulics.Units.PressureDifference p_net "Pressure that drives the flow";
  Mechanics.Units.Torque tau_s "Torque of the one-way clutch on the stator, not negative";
equation
  // Shafts
  w_p = impeller.w;
  w_t = turbine.w;
  // Steady flow
  tau_h = Functions.torques(Q, w_p, w_t, w_s, geometry);
  p_net = Functions.netPressure(Q, w_p, w_t, w_s, geometry);
  annotation(Documentation(info = "<html>
<p>The extending models say which inertias count.</p>
</html>"));
end PartialCircuit;
