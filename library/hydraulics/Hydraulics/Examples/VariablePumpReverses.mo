within Hydraulics.Examples;
model VariablePumpReverses "A pump carries oil between two closed volumes and back"
  Mechanics.Rotational.Sources.Speed drive(w_start = 100) "Shaft";
  Signals.Sources.SmoothSteps setting(times = {0.1, 0.5}, values = {0, 0.5, -0.5}, duration = 0.2) "Displacement";
  Components.Volume left(n = 1, V_0 = 1e-3, p_start = 20e5, p(fixed = true)) "Closed volume";
  Components.Volume right(n = 1, V_0 = 1e-3, p_start = 20e5, p(fixed = true)) "Closed volume";
  Components.VariablePump pump(D = 0.02e-6, leakage = 1e-14) "Pump under test";
  output Real error(unit = "1") "Mass lost between both volumes, relative";
protected
  parameter Mechanics.Units.Mass m_0 = 2*Media.density(20e5, left.fluid)*left.V_0 "Mass at time 0";
equation
  connect(drive.flange, pump.flange);
  connect(setting.y, pump.setting);
  connect(left.port[1], pump.port_a);
  connect(pump.port_b, right.port[1]);
  error = (left.m + right.m)/m_0 - 1;
  annotation(
    experiment(StopTime = 1, Tolerance = 1e-8),
    Documentation(info = "<html>
<p>Both volumes together keep their mass while the flow reverses.</p>
</html>"));
end VariablePumpReverses;
