within TenSpeed.Interfaces;
partial model RegulationCircuit "Pump or pressure, main, lubrication and converter regulators, accumulator valve"
  replaceable package Oil = Hydraulics.Media.OilDexronVI constrainedby Hydraulics.Media.PartialOil
    "Oil whose data are the default" annotation(choicesAllMatching = true);
  parameter Hydraulics.Media.Fluid fluid = Oil.data "Oil of the circuit";
  replaceable model Main = Valves.MainRegulator constrainedby Valves.MainRegulator "Level of the main regulator"
    annotation(choicesAllMatching = true);
  replaceable model Lubrication = Valves.LubricationRegulator constrainedby PartialReliefRegulator
    "Level of the lubrication regulator" annotation(choicesAllMatching = true);
  replaceable model Converter = Valves.ConverterRegulator constrainedby PartialReliefRegulator
    "Level of the converter regulator" annotation(choicesAllMatching = true);
  replaceable model Accumulator = Valves.LineAccumulator constrainedby Valves.LineAccumulator
    "Level of the accumulator valve" annotation(choicesAllMatching = true);
  replaceable Hydraulics.Sources.FlowSource supply(
    q_start = 0,
    q_end = 30/60000,
    startTime = 0.1,
    duration = 1.7) constrainedby Hydraulics.Interfaces.PartialSource "Supply, a flow or a pressure";
  Signals.Sources.SmoothSteps command(
    times = {0.02},
    values = {101325, 3e5},
    duration = 0.1) "Pressure of the line's solenoid: at rest, then in the middle of its range";
  Hydraulics.Sources.PressureSignal pilot "Line's solenoid";
  Main main(final fluid = fluid) "Main regulator with the line";
  Converter converter(final fluid = fluid) "Converter regulator with its line";
  Lubrication lubrication(final fluid = fluid) "Lubrication regulator with its line";
  Accumulator accumulator(final fluid = fluid) "Accumulator valve at the line";
  Hydraulics.Components.Orifice converterLoad(final fluid = fluid, d = 2e-3) "Torque converter and cooler; chosen: 6 l/min";
  Hydraulics.Components.Orifice lubricationLoad(final fluid = fluid, d = 2.5e-3) "Consumers of lubrication; chosen: 4.5 l/min";
  Hydraulics.Sources.Tank sump "Sump and pump inlet";
  output Hydraulics.Units.AbsolutePressure p_line = main.line.p "Pressure of the line";
  output Hydraulics.Units.AbsolutePressure p_converter = converter.inlet.p "Pressure of the converter line";
  output Hydraulics.Units.AbsolutePressure p_lubrication = lubrication.inlet.p "Pressure of the lubrication line";
  output Hydraulics.Units.VolumeFlowRate q_supply = -supply.port.q "Flow from the supply";
  output Hydraulics.Units.MassFlowRate inflow
    "Mass flow into the circuit, from supply and pilot";
  output Hydraulics.Units.MassFlowRate outflow "Mass flow out of the circuit, to the sump";
  output Mechanics.Units.Mass m_oil = main.m_oil + converter.m_oil + lubrication.m_oil + accumulator.m_oil
    "Mass of oil and air in the circuit";
equation
  // Line
  connect(command.y, pilot.p);
  connect(supply.port, main.line);
  connect(accumulator.port, main.line);
  connect(pilot.port, main.pilot);
  connect(main.suction, sump.port);
  // Converter
  connect(main.converter, converter.inlet);
  connect(converter.inlet, converterLoad.port_a);
  connect(converterLoad.port_b, lubrication.inlet);
  connect(converter.drain, lubrication.inlet);
  // Lubrication
  connect(main.lubrication, lubrication.inlet);
  connect(lubrication.inlet, lubricationLoad.port_a);
  connect(lubricationLoad.port_b, sump.port);
  connect(lubrication.drain, sump.port);
  // Balance
  inflow = -Hydraulics.Media.density(p_line, fluid)*supply.port.q
    - Hydraulics.Media.density(pilot.port.p, fluid)*pilot.port.q;
  outflow = Hydraulics.Media.density(sump.port.p, fluid)*sump.port.q;
  annotation(Documentation(info = "<html>
<p>The main regulator feeds first the converter, then lubrication, and returns the rest; the converter regulator passes on
to lubrication what the converter does not take. inflow - outflow = d m_oil/dt. With a flow source the line's pressure is a
state; a pressure source takes it away.</p>
</html>"));
end RegulationCircuit;
