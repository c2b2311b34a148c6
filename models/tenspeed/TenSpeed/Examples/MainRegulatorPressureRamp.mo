within TenSpeed.Examples;
model MainRegulatorPressureRamp "Main-regulator circuit with a line pressure that rises smoothly: four states"
  extends Interfaces.MainRegulatorCircuit;
  Hydraulics.Sources.PressureSource supply(
    p_start = 6e5,
    p_end = 10.5e5,
    startTime = 0.2,
    duration = 0.3) "Line pressure; chosen: from closed valve to all edges open";
equation
  // Supply
  connect(supply.port, line.port[1]);
  annotation(
    experiment(StopTime = 1, Tolerance = 1e-6),
    Documentation(info = "<html>
<p>As MainRegulatorPressure, with a time-varying pressure: its derivative enters the flow into the line.</p>
</html>"));
end MainRegulatorPressureRamp;
