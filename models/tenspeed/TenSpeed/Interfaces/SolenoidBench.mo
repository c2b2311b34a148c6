within TenSpeed.Interfaces;
partial model SolenoidBench "Solenoid valve alone: current command, supply, drain and a load at the outlet"
  replaceable package Oil = Hydraulics.Media.OilDexronVI constrainedby Hydraulics.Media.PartialOil
    "Oil whose data are the default" annotation(choicesAllMatching = true);
  parameter Hydraulics.Media.Fluid fluid = Oil.data "Oil of valve and loads";
  replaceable model Valve = Valves.LinearSolenoid constrainedby PartialSolenoidValve "Valve under test"
    annotation(choicesAllMatching = true);
  Valve valve(final fluid = fluid) "Valve under test";
  Signals.Sources.SmoothSteps command(
    times = {0.2*k for k in 1:20},
    values = cat(1, {0.1*k for k in 0:10}, {0.1*(10 - k) for k in 1:10}),
    duration = 0.02) "Current: up and down in steps of 0.1 A";
  replaceable Hydraulics.Sources.PressureSource supply(p_start = 10.5e5) constrainedby Hydraulics.Interfaces.PartialSource
    "Supply, a pressure or a flow";
  Hydraulics.Sources.Tank drain "Drain";
  Hydraulics.Components.Orifice load(final fluid = fluid, d = 0.6e-3) "Load; chosen: leakage of a clutch's seals";
  Hydraulics.Sources.Tank sink "Pressure behind the load";
  output Electrical.Units.Current i_cmd = command.y "Command";
  output Electrical.Units.Current i = valve.i "Current in the coil";
  output Mechanics.Units.Position s = valve.s "Position of the spool";
  output Hydraulics.Units.AbsolutePressure p_supply = valve.supply.p "Pressure of the supply";
  output Hydraulics.Units.AbsolutePressure p_out = valve.outlet.p "Pressure of the outlet";
  output Hydraulics.Units.MassFlowRate inflow = valve.m_supply "Mass flow into the valve";
  output Hydraulics.Units.MassFlowRate outflow = valve.m_drain + valve.m_outlet "Mass flow out of the valve";
  output Mechanics.Units.Mass m_oil = valve.m_oil "Mass of oil and air in the valve";
equation
  connect(command.y, valve.i_cmd);
  connect(supply.port, valve.supply);
  connect(valve.drain, drain.port);
  connect(valve.outlet, load.port_a);
  connect(load.port_b, sink.port);
  annotation(Documentation(info = "<html>
<p>inflow - outflow = d m_oil/dt. Redeclare <code>supply</code> for another one, as
<code>Hydraulics.Sources.SlippingPump</code>.</p>
</html>"));
end SolenoidBench;
