within TenSpeed.Interfaces;
partial model ReliefRegulatorBench "Lubrication or converter regulator alone: supply, feed, load and drain"
  replaceable package Oil = Hydraulics.Media.OilDexronVI constrainedby Hydraulics.Media.PartialOil
    "Oil whose data are the default" annotation(choicesAllMatching = true);
  parameter Hydraulics.Media.Fluid fluid = Oil.data "Oil of valve and loads";
  replaceable model Valve = Valves.LubricationRegulator constrainedby PartialReliefRegulator "Valve under test"
    annotation(choicesAllMatching = true);
  Valve valve(final fluid = fluid) "Valve under test";
  parameter Hydraulics.Units.Diameter d_load = 2e-3 "Load";
  parameter Hydraulics.Units.AbsolutePressure p_drain = 101325 "Pressure behind the valve";
  replaceable Hydraulics.Sources.FlowSource supply(
    q_start = 5/60000,
    q_end = 20/60000,
    startTime = 0.5,
    duration = 2) constrainedby Hydraulics.Interfaces.PartialSource "Supply, a flow or a pressure";
  Hydraulics.Components.LaminarOrifice feed(final fluid = fluid, d = 6e-3, l = 2) "Feed; chosen: 4 bar at 15 l/min";
  Hydraulics.Components.Orifice load(final fluid = fluid, d = d_load) "Consumers";
  Hydraulics.Sources.Tank sink "Behind the consumers";
  Hydraulics.Sources.PressureSource drain(p_start = p_drain) "Behind the valve";
  output Hydraulics.Units.AbsolutePressure p_out = valve.inlet.p "Pressure that the valve regulates";
  output Hydraulics.Units.VolumeFlowRate q_drain = -valve.drain.q "Flow through the valve";
  output Mechanics.Units.Position s = valve.s "Position of the spool";
  output Hydraulics.Units.MassFlowRate inflow = valve.m_in "Mass flow into the valve";
  output Hydraulics.Units.MassFlowRate outflow = valve.m_out "Mass flow out of the valve";
  output Mechanics.Units.Mass m_oil = valve.m_oil "Mass of oil and air in the valve";
equation
  connect(supply.port, feed.port_a);
  connect(feed.port_b, valve.inlet);
  connect(valve.inlet, load.port_a);
  connect(load.port_b, sink.port);
  connect(valve.drain, drain.port);
  annotation(Documentation(info = "<html>
<p>inflow - outflow = d m_oil/dt.</p>
</html>"));
end ReliefRegulatorBench;
