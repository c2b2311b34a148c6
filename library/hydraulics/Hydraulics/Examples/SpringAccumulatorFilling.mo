within Hydraulics.Examples;
model SpringAccumulatorFilling "A constant flow moves the piston of an accumulator from stop to stop"
  Sources.FlowSource pump(q_start = 1e-5) "Pump";
  Components.SpringAccumulator accumulator(
    A = 5e-4,
    c = 1e4,
    F_preload = 100,
    s_max = 0.02,
    V_dead = 5e-6,
    p(fixed = true)) "Accumulator under test";
  Mechanics.Units.Mass delivered(start = 0, fixed = true) "Mass delivered by the pump";
  output Real error(unit = "1") "Mass not accounted for, relative";
protected
  parameter Mechanics.Units.Position s_0 = -accumulator.F_preload/(accumulator.c + accumulator.c_stop) "Position at time 0";
  parameter Mechanics.Units.Mass m_0 = Media.density(accumulator.p_start, accumulator.fluid)
    *(accumulator.V_dead + accumulator.A*s_0) "Mass at time 0";
equation
  connect(pump.port, accumulator.port);
  // Conservation of mass through both end stops
  der(delivered) = accumulator.rho*pump.q;
  error = (accumulator.m - m_0 - delivered)/m_0;
  annotation(
    experiment(StopTime = 1, Tolerance = 1e-8),
    Documentation(info = "<html>
<p>What the pump delivers is found in the accumulator: at its lower stop, on its way, and at its upper stop.</p>
</html>"));
end SpringAccumulatorFilling;
