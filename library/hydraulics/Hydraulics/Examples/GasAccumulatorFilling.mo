within Hydraulics.Examples;
model GasAccumulatorFilling "A constant flow fills an accumulator with gas"
  Sources.FlowSource pump(q_start = 1e-4) "Pump";
  Components.GasAccumulator accumulator(V_0 = 0.5e-3, p_0 = 10e5, p(fixed = true)) "Accumulator under test";
  Mechanics.Units.Mass delivered(start = 0, fixed = true) "Mass delivered by the pump";
  output Real error(unit = "1") "Mass or gas not accounted for, relative";
protected
  parameter Mechanics.Units.Mass m_0 = Media.density(accumulator.p_start, accumulator.fluid)*accumulator.V_dead
    "Mass at time 0";
equation
  connect(pump.port, accumulator.port);
  // Conservation of mass, and the law of the gas once it is compressed
  der(delivered) = accumulator.rho*pump.q;
  error = (accumulator.m - m_0 - delivered)/m_0
    + noEvent(if accumulator.p > accumulator.p_0
      then accumulator.p*accumulator.V_gas^accumulator.n/(accumulator.p_0*accumulator.V_0^accumulator.n) - 1 else 0);
  annotation(
    experiment(StopTime = 3, Tolerance = 1e-8),
    Documentation(info = "<html>
<p>What the pump delivers is found in the accumulator, and p V<sup>n</sup> stays what it was.</p>
</html>"));
end GasAccumulatorFilling;
