within TenSpeed.Interfaces;
partial model LockupBench "Lock-up control valve alone: command pressure, supply, drain and load"
  replaceable package Oil = Hydraulics.Media.OilDexronVI constrainedby Hydraulics.Media.PartialOil
    "Oil whose data are the default" annotation(choicesAllMatching = true);
  parameter Hydraulics.Media.Fluid fluid = Oil.data "Oil of valve and loads";
  replaceable model Valve = Valves.LockupControl constrainedby Valves.LockupControl "Valve under test"
    annotation(choicesAllMatching = true);
  Valve valve(final fluid = fluid) "Valve under test";
  Signals.Sources.SmoothSteps command(
    times = {0.2*k for k in 1:20},
    values = 101325*ones(21) + 0.6e5*cat(1, {k for k in 0:10}, {10 - k for k in 1:10}),
    duration = 0.02) "Pressure of the solenoid: up and down in steps of 0.6 bar";
  Hydraulics.Sources.PressureSignal solenoid "Command";
  replaceable Hydraulics.Sources.PressureSource supply(p_start = 10.5e5) constrainedby Hydraulics.Interfaces.PartialSource
    "Supply, a pressure or a flow";
  Hydraulics.Sources.Tank drain "Drain";
  Hydraulics.Components.Orifice load(final fluid = fluid, d = 1e-3) "Load; chosen: leakage of the clutch";
  Hydraulics.Sources.Tank sink "Behind the load";
  output Hydraulics.Units.AbsolutePressure p_command = valve.command.p "Command";
  output Hydraulics.Units.AbsolutePressure p_supply = valve.supply.p "Pressure of the supply";
  output Hydraulics.Units.AbsolutePressure p_out = valve.outlet.p "Pressure of the clutch";
  output Mechanics.Units.Position s = valve.s "Position of the spool";
  output Hydraulics.Units.MassFlowRate inflow = valve.m_supply + valve.m_command "Mass flow into the valve";
  output Hydraulics.Units.MassFlowRate outflow = valve.m_drain + valve.m_outlet "Mass flow out of the valve";
  output Mechanics.Units.Mass m_oil = valve.m_oil "Mass of oil and air in the valve";
equation
  connect(command.y, solenoid.p);
  connect(solenoid.port, valve.command);
  connect(supply.port, valve.supply);
  connect(valve.drain, drain.port);
  connect(valve.outlet, load.port_a);
  connect(load.port_b, sink.port);
  annotation(Documentation(info = "<html>
<p>inflow - outflow = d m_oil/dt.</p>
</html>"));
end LockupBench;
