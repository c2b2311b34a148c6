within TenSpeed.Interfaces;
partial model MainRegulatorCircuit "Main-regulator circuit without its supply"
  replaceable package Oil = Hydraulics.Media.OilDexronVI constrainedby Hydraulics.Media.PartialOil
    "Oil whose data are the default" annotation(choicesAllMatching = true);
  parameter Hydraulics.Media.Fluid fluid = Oil.data "Oil";
  Hydraulics.Components.Volume line(
    n = 3,
    V_0 = 500e-6,
    final fluid = fluid) "Line; chosen: pump outlet, valve body and lines to the clutches. Port 1 is for the supply";
  Hydraulics.Valves.MainRegulatorValve valve(final fluid = fluid) "Main regulator valve";
  Hydraulics.Sources.PressureSource pilot(p_start = 3e5) "Pilot supply; chosen: middle of a solenoid's range";
  Hydraulics.Sources.PressureSource converter(p_start = 4e5) "Converter circuit; chosen: usual charge pressure";
  Hydraulics.Sources.PressureSource lubrication(p_start = 2e5) "Lubrication circuit; chosen: usual feed pressure";
  Hydraulics.Sources.Tank suction "Pump inlet";
equation
  // Line
  connect(line.port[2], valve.line);
  connect(line.port[3], valve.feedback);
  // Prescribed pressures
  connect(pilot.port, valve.pilot);
  connect(valve.converter, converter.port);
  connect(valve.lubrication, lubrication.port);
  connect(valve.suction, suction.port);
  annotation(Documentation(info = "<html>
<p>Connect a source to <code>line.port[1]</code>: with a flow source the pressure of the line is a state and the valve
regulates it (states: spool position and speed, pressures of line, feedback and pilot chamber); with a pressure source
that state disappears.</p>
</html>"));
end MainRegulatorCircuit;
