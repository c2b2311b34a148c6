within Hydraulics.Examples;
model TwoOils "The same filling with two oils, chosen by redeclaration"
  Sources.FlowSource pump_a(q_start = 1e-5) "Pump";
  Sources.FlowSource pump_b(q_start = 1e-5) "Pump";
  Components.Volume transmission(n = 1, V_0 = 1e-3, p(fixed = true)) "Volume with the transmission's oil";
  Components.Volume hydraulic(
    redeclare package Oil = Media.OilMineralVG32,
    n = 1,
    V_0 = 1e-3,
    p(fixed = true)) "Volume with mineral oil";
  Mechanics.Units.Mass delivered(start = 0, fixed = true) "Mass delivered to the mineral oil";
  output Real error(unit = "1") "Mass of the mineral oil not accounted for, relative";
protected
  parameter Mechanics.Units.Mass m_0 = hydraulic.fluid.rho_ref*hydraulic.V_0 "Mass at time 0";
equation
  connect(pump_a.port, transmission.port[1]);
  connect(pump_b.port, hydraulic.port[1]);
  der(delivered) = hydraulic.rho*pump_b.q;
  error = (hydraulic.m - m_0 - delivered)/m_0;
  assert(time < 0.5 or hydraulic.p > transmission.p, "the oil with less air must be stiffer");
  annotation(
    experiment(StopTime = 1, Tolerance = 1e-8),
    Documentation(info = "<html>
<p>What the pump delivers is found in the volume, by the density of its own oil.</p>
</html>"));
end TwoOils;
