within Hydraulics.Examples;
model VolumeFilling "A constant flow fills a closed volume"
  Sources.FlowSource pump(q_start = 1e-5) "Pump";
  Components.Volume volume(n = 1, V_0 = 1e-3, p(fixed = true)) "Closed volume";
  Mechanics.Units.Mass delivered(start = 0, fixed = true) "Mass delivered by the pump";
  output Mechanics.Units.Mass error "Mass in the volume not accounted for";
protected
  parameter Mechanics.Units.Mass m_0 = Media.density(volume.p_start, volume.fluid)*volume.V_0 "Mass at time 0";
equation
  connect(pump.port, volume.port[1]);
  // Conservation of mass
  der(delivered) = volume.rho*pump.q;
  error = volume.m - m_0 - delivered;
  annotation(
    experiment(StopTime = 1, Tolerance = 1e-8),
    Documentation(info = "<html>
<p>What the pump delivers is found in the volume.</p>
</html>"));
end VolumeFilling;
