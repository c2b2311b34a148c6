within TenSpeed.Interfaces;
partial model MainRegulatorBench "Main regulator alone, its outlets at prescribed pressures"
  replaceable package Oil = Hydraulics.Media.OilDexronVI constrainedby Hydraulics.Media.PartialOil
    "Oil whose data are the default" annotation(choicesAllMatching = true);
  parameter Hydraulics.Media.Fluid fluid = Oil.data "Oil of valve and loads";
  replaceable model Valve = Valves.MainRegulator constrainedby Valves.MainRegulator "Valve under test"
    annotation(choicesAllMatching = true);
  Valve valve(final fluid = fluid) "Valve under test";
  replaceable Hydraulics.Sources.FlowSource supply(
    q_start = 5/60000,
    q_end = 30/60000,
    startTime = 0.5,
    duration = 2) constrainedby Hydraulics.Interfaces.PartialSource "Supply, a flow or a pressure";
  Signals.Sources.SmoothSteps command(
    times = {0.02},
    values = {101325, 3e5},
    duration = 0.1) "Pilot pressure: at rest, then in the middle of a solenoid's range";
  Hydraulics.Sources.PressureSignal pilot "Pilot supply";
  Hydraulics.Sources.PressureSource converter(p_start = 5e5) "Converter circuit; chosen: usual charge pressure";
  Hydraulics.Sources.PressureSource lubrication(p_start = 3e5) "Lubrication circuit; chosen: usual feed pressure";
  Hydraulics.Sources.Tank suction "Pump inlet";
  output Hydraulics.Units.AbsolutePressure p_line = valve.line.p "Pressure of the line";
  output Hydraulics.Units.AbsolutePressure p_pilot = valve.pilot.p "Pilot pressure";
  output Hydraulics.Units.VolumeFlowRate q_supply = valve.line.q "Flow from the supply";
  output Mechanics.Units.Position s = valve.s "Position of the spool";
  output Hydraulics.Units.MassFlowRate inflow = valve.m_in "Mass flow into the valve";
  output Hydraulics.Units.MassFlowRate outflow = valve.m_out "Mass flow out of the valve";
  output Mechanics.Units.Mass m_oil = valve.m_oil "Mass of oil and air in the valve";
equation
  connect(command.y, pilot.p);
  connect(supply.port, valve.line);
  connect(pilot.port, valve.pilot);
  connect(valve.converter, converter.port);
  connect(valve.lubrication, lubrication.port);
  connect(valve.suction, suction.port);
  annotation(Documentation(info = "<html>
<p>inflow - outflow = d m_oil/dt.</p>
</html>"));
end MainRegulatorBench;
