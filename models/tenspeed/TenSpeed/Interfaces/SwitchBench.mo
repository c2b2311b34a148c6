within TenSpeed.Interfaces;
partial model SwitchBench "Switch valve alone: pilot pressure, supply, drain and a load at the outlet"
  replaceable package Oil = Hydraulics.Media.OilDexronVI constrainedby Hydraulics.Media.PartialOil
    "Oil whose data are the default" annotation(choicesAllMatching = true);
  parameter Hydraulics.Media.Fluid fluid = Oil.data "Oil of valve and loads";
  replaceable model Valve = Valves.SwitchValve constrainedby Valves.SwitchValve "Valve under test"
    annotation(choicesAllMatching = true);
  Valve valve(final fluid = fluid) "Valve under test";
  Signals.Sources.SmoothSteps command(
    times = {0.2, 2.6},
    values = {101325, 6e5, 101325},
    duration = 2) "Pilot pressure: slowly up and down";
  Hydraulics.Sources.PressureSignal pilot "Pilot pressure";
  replaceable Hydraulics.Sources.PressureSource supply(p_start = 10.5e5) constrainedby Hydraulics.Interfaces.PartialSource
    "Supply, a pressure or a flow";
  Hydraulics.Sources.Tank drain "Drain";
  Hydraulics.Components.Orifice load(final fluid = fluid, d = 1e-3) "Load; chosen: leakage of a clutch's seals and of its line";
  Hydraulics.Sources.Tank sink "Pressure behind the load";
  output Hydraulics.Units.AbsolutePressure p_pilot = valve.pilot.p "Pilot pressure";
  output Mechanics.Units.Position s = valve.s "Position of the spool";
  output Hydraulics.Units.AbsolutePressure p_supply = valve.supply.p "Pressure of the supply";
  output Hydraulics.Units.AbsolutePressure p_out = valve.outlet.p "Pressure of the outlet";
  output Hydraulics.Units.MassFlowRate inflow "Mass flow into the valve";
  output Hydraulics.Units.MassFlowRate outflow = valve.m_drain + valve.m_outlet "Mass flow out of the valve";
  output Mechanics.Units.Mass m_oil = valve.m_oil "Mass of oil and air in the valve";
equation
  connect(command.y, pilot.p);
  connect(pilot.port, valve.pilot);
  connect(supply.port, valve.supply);
  connect(valve.drain, drain.port);
  connect(valve.outlet, load.port_a);
  connect(load.port_b, sink.port);
  annotation(Documentation(info = "<html>
<p>inflow - outflow = d m_oil/dt.</p>
</html>"));
end SwitchBench;
