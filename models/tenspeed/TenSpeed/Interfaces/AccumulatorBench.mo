within TenSpeed.Interfaces;
partial model AccumulatorBench "Accumulator valve alone at a line whose pressure rises and falls"
  replaceable package Oil = Hydraulics.Media.OilDexronVI constrainedby Hydraulics.Media.PartialOil
    "Oil whose data are the default" annotation(choicesAllMatching = true);
  parameter Hydraulics.Media.Fluid fluid = Oil.data "Oil of valve and loads";
  replaceable model Valve = Valves.LineAccumulator constrainedby Valves.LineAccumulator "Valve under test"
    annotation(choicesAllMatching = true);
  Valve valve(final fluid = fluid) "Valve under test";
  replaceable Hydraulics.Sources.PressureSource supply(
    p_start = 101325,
    p_end = 12e5,
    startTime = 0.1,
    duration = 0.3) constrainedby Hydraulics.Interfaces.PartialSource "Line, a pressure or a flow";
  output Hydraulics.Units.AbsolutePressure p_line = valve.port.p "Pressure of the line";
  output Mechanics.Units.Position s = valve.s "Position of the piston";
  output Hydraulics.Units.MassFlowRate inflow = valve.m_in "Mass flow into the valve";
  output Hydraulics.Units.MassFlowRate outflow = 0 "Nothing flows out elsewhere";
  output Mechanics.Units.Mass m_oil = valve.m_oil "Mass of oil and air in the valve";
equation
  connect(supply.port, valve.port);
  annotation(Documentation(info = "<html>
<p>inflow = d m_oil/dt.</p>
</html>"));
end AccumulatorBench;
